// An external planner for oxturn in C++ and nothing but its standard library: a depth-first walk over grid points.
//
//   g++ -std=c++17 -O2 -o walk docs/planners/walk.cpp
//   oxturn plan --exec ./walk rooms:7 --svg walk.svg
//
// README.md in this folder describes the protocol. The file has three parts: a small JSON reader, the planner, and the
// conversation.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <map>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

// --- JSON ----------------------------------------------------------------------------------------------------

struct Json {
  double number = 0;  // also true: 1, false and null: 0
  std::string text;
  std::vector<Json> items;
  std::map<std::string, Json> members;

  const Json& operator[](const std::string& name) const {
    const auto found = members.find(name);
    if (found == members.end()) throw std::runtime_error("the problem has no member " + name);
    return found->second;
  }
};

class Reader {
 public:
  explicit Reader(const std::string& text) : at_(text.c_str()) {}

  Json value() {
    switch (next()) {
      case '{':
        return object();
      case '[':
        return list();
      case '"':
        return string();
      case 't':
        return word("true", 1);
      case 'f':
        return word("false", 0);
      case 'n':
        return word("null", 0);
      default:
        return number();
    }
  }

 private:
  char next() {
    while (*at_ == ' ' || *at_ == '\t' || *at_ == '\r' || *at_ == '\n') ++at_;
    return *at_;
  }
  void expect(char c) {
    if (next() != c) throw std::runtime_error(std::string("not JSON: expected ") + c);
    ++at_;
  }
  bool follows(char c) {
    if (next() != c) return false;
    ++at_;
    return true;
  }
  Json object() {
    Json all;
    expect('{');
    if (follows('}')) return all;
    do {
      const std::string name = string().text;
      expect(':');
      all.members[name] = value();
    } while (follows(','));
    expect('}');
    return all;
  }
  Json list() {
    Json all;
    expect('[');
    if (follows(']')) return all;
    do all.items.push_back(value());
    while (follows(','));
    expect(']');
    return all;
  }
  Json string() {
    Json value;
    expect('"');
    for (; *at_ != '"' && *at_ != 0; ++at_) {
      if (*at_ == '\\' && at_[1] != 0) ++at_;  // escapes stay as they are: this planner needs names of members only
      value.text += *at_;
    }
    expect('"');
    return value;
  }
  Json word(const std::string& text, double number) {
    for (const char c : text) expect(c);
    Json value;
    value.number = number;
    return value;
  }
  Json number() {
    Json value;
    char* end = nullptr;
    value.number = std::strtod(at_, &end);
    if (end == at_) throw std::runtime_error("not JSON: expected a value");
    at_ = end;
    return value;
  }

  const char* at_;
};

// --- the planner ---------------------------------------------------------------------------------------------

struct Point {
  double x = 0, y = 0;
};
using Edge = std::pair<Point, Point>;
using Node = std::pair<int, int>;  // column, row

std::vector<Edge> edges_of(const Json& geometry) {
  std::vector<Edge> edges;
  const auto add = [&](const Json& polygon) {
    for (const Json& ring : polygon.items)
      for (std::size_t i = 0; i + 1 < ring.items.size(); ++i) {
        const auto point = [&](std::size_t k) {
          return Point{ring.items[k].items.at(0).number, ring.items[k].items.at(1).number};
        };
        edges.push_back({point(i), point(i + 1)});
      }
  };
  if (geometry["type"].text == "Polygon")
    add(geometry["coordinates"]);
  else
    for (const Json& polygon : geometry["coordinates"].items) add(polygon);
  return edges;
}

double side(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Grid points through the start, and which straight moves between neighbours stay inside.
class Grid {
 public:
  Grid(std::vector<Edge> edges, const Point& origin, double step)
      : edges_(std::move(edges)), origin_(origin), step_(step) {}

  Point point(const Node& node) const { return {origin_.x + node.first * step_, origin_.y + node.second * step_}; }

  bool free_between(const Node& a, const Node& b) const {
    const Point p = point(a), q = point(b);
    for (const auto& [c, d] : edges_)
      if (side(p, q, c) * side(p, q, d) <= 0 && side(c, d, p) * side(c, d, q) <= 0) return false;
    return true;
  }

 private:
  std::vector<Edge> edges_;
  Point origin_;
  double step_;
};

struct Leg {
  bool tool;
  std::vector<Point> points;
};

/// Visits every grid point that moves reach from the start: the tool is on where the walk goes on, else off.
std::vector<Leg> walk(const Grid& grid, std::mt19937_64& random) {
  std::vector<Leg> legs;
  std::vector<Node> stack{{0, 0}};
  std::map<Node, bool> visited{{stack.back(), true}};
  const auto drive = [&](const Node& from, const Node& to, bool tool) {
    if (legs.empty() || legs.back().tool != tool) legs.push_back({tool, {grid.point(from)}});
    legs.back().points.push_back(grid.point(to));
  };
  const int turn = static_cast<int>(random() % 4);  // which direction is tried first: one seed, one path
  const Node steps[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  while (!stack.empty()) {
    const Node here = stack.back();
    bool moved = false;
    for (int k = 0; k < 4 && !moved; ++k) {
      const Node& step = steps[(k + turn) % 4];
      const Node there{here.first + step.first, here.second + step.second};
      if (visited.count(there) > 0 || !grid.free_between(here, there)) continue;
      visited[there] = moved = true;
      drive(here, there, true);
      stack.push_back(there);
    }
    if (moved) continue;
    stack.pop_back();
    if (!stack.empty()) drive(here, stack.back(), false);
  }
  if (!legs.empty() && !legs.back().tool) legs.pop_back();  // no need to return at the end
  return legs;
}

// --- the conversation ----------------------------------------------------------------------------------------

std::string geojson(const std::vector<Leg>& legs) {
  std::string text = R"({"type": "FeatureCollection", "features": [)";
  char number[80];
  for (std::size_t i = 0; i < legs.size(); ++i) {
    text += i > 0 ? ", " : "";
    text += std::string(R"({"type": "Feature", "properties": {"tool": )") + (legs[i].tool ? "true" : "false");
    text += R"(}, "geometry": {"type": "LineString", "coordinates": [)";
    for (std::size_t k = 0; k < legs[i].points.size(); ++k) {
      std::snprintf(number, sizeof number, "%s[%.17g, %.17g]", k > 0 ? ", " : "", legs[i].points[k].x,
                    legs[i].points[k].y);
      text += number;
    }
    text += "]}}";
  }
  return text + "]}";
}

constexpr const char* kDescription =
    R"({"oxturn": 1, "name": "walk", "title": "a depth-first walk over grid points", )"
    R"("citation": "an example", "guarantee": "visits every grid point that the start is connected to", )"
    R"("promise": "nothing", "capabilities": ["holes", "footprint"], "parameters": [)"
    R"({"name": "step", "type": "number", "default": 0.7, "least": 0.05, "most": 1, )"
    R"("help": "distance of grid points, in tool widths"}]})";

void plan(const std::string& line) {
  const Json message = Reader(line).value();
  const Json& problem = message["problem"];
  const Json& properties = problem["properties"];
  const Json& start = properties["start"];
  const double step = message["settings"]["step"].number * properties["robot"]["tool_width"].number;
  const Grid grid(edges_of(problem["configuration_space"]), {start.items.at(0).number, start.items.at(1).number}, step);
  std::mt19937_64 random(static_cast<std::uint64_t>(message["seed"].number));
  const std::vector<Leg> legs = walk(grid, random);
  if (legs.empty())
    std::cout << R"({"error": "infeasible", "reason": "no grid point is free beside the start; try a smaller step"})"
              << std::endl;
  else
    std::cout << R"({"path": )" << geojson(legs) << "}" << std::endl;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 2 && std::string(argv[1]) == "--describe") {
    std::cout << kDescription << std::endl;
    return 0;
  }
  std::cout << R"({"ready": true})" << std::endl;
  std::string line;
  std::getline(std::cin, line);
  try {
    plan(line);
  } catch (const std::exception& e) {
    std::cerr << e.what() << std::endl;
    return 1;
  }
  return 0;
}
