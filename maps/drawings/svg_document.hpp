/// An XML document whose nodes know their lines, within limits. Private to maps.
///
///   const Document document(text, "whale.svg");
///   document.refuse(node, "circle has no radius");      // throws "whale.svg:12: circle has no radius"
#pragma once

#include <map>
#include <pugixml.hpp>
#include <string>
#include <unordered_map>
#include <vector>

namespace oxturn::svg {

class Document {
 public:
  /// Throws std::invalid_argument "FILE:LINE: what is wrong" for text that is not XML, above 16 MiB, with more than
  /// 10^6 nodes or elements nested deeper than 256.
  Document(const std::string& text, std::string file);

  pugi::xml_node root() const { return xml_.document_element(); }
  std::size_t line(const pugi::xml_node& node) const;
  [[noreturn]] void refuse(const pugi::xml_node& node, const std::string& sentence) const;
  const std::string& file() const { return file_; }

  /// The first element with this id; empty if there is none.
  pugi::xml_node find(const std::string& id) const;
  /// Its id if no other element has it, else its position among its parents' children: "0/3/1".
  std::string name_of(const pugi::xml_node& node) const;
  const std::vector<pugi::xml_node>& style_sheets() const { return style_sheets_; }

 private:
  struct Named {
    pugi::xml_node first;
    std::size_t count = 0;
  };
  void visit_all();
  std::size_t line_at(std::ptrdiff_t offset) const;

  std::string file_;
  pugi::xml_document xml_;
  std::vector<std::size_t> line_ends_;
  std::map<std::string, Named> ids_;
  std::unordered_map<std::size_t, std::size_t> positions_;  // among its parent's elements, by the node's identity
  std::vector<pugi::xml_node> style_sheets_;
};

}  // namespace oxturn::svg
