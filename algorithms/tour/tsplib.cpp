// TSPLIB files: KEYWORD : VALUE lines, then sections of numbers.
//
// Decisions   1. Keywords and values are read in any case, with or without a blank before the colon; sections end where
//                a keyword stands. EOF is optional.
//             2. What has no effect on costs is skipped: COMMENT, DISPLAY_DATA_TYPE, DISPLAY_DATA_SECTION,
//                NODE_COORD_TYPE. Any other keyword is refused, since it may change the problem.
//             3. Numbers of nodes must be 1 to DIMENSION, each once, in any order.
#include "algorithms/tour/tsplib.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>

#include "base/text.hpp"
#include "base/throw_invalid.hpp"

namespace oxturn {
namespace {

constexpr std::size_t kMostNodes = 1000000;
constexpr std::size_t kMostMatrixNodes = 10000;
constexpr double kComesBefore = -1;     // a weight from i to j of a SOP: j comes before i
constexpr std::size_t kMostShown = 40;  // bytes of a word in messages

std::string upper(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return out;
}

/// Distances between points, rounded as TSPLIB says.
class RoundedCost final : public ConnectionCost {
 public:
  RoundedCost(const std::vector<Point>& points, bool up) : up_(up) {
    for (const Point& p : points) ends_.push_back({p, p});
  }
  double operator()(PatternId from, PatternId to) const override {
    const double d = distance(ends_[from].exit, ends_[to].entry);
    return up_ ? std::ceil(d) : std::floor(d + 0.5);
  }
  bool symmetric(const std::vector<PatternId>& reverse) const override {
    return std::ranges::find(reverse, kNoPattern) == reverse.end();
  }
  const std::vector<Ends>* ends() const override { return &ends_; }

 private:
  std::vector<Ends> ends_;
  bool up_;
};

/// Words of a file with their lines; a keyword line is one word and its value.
class Words {
 public:
  Words(std::string_view text, const std::string& source) : rest_(text), source_(source) {}

  template <class... Args>
  [[noreturn]] void fail(fmt::format_string<Args...> text, Args&&... args) const {
    throw_invalid("{}:{}: {}", source_, line_, fmt::format(text, std::forward<Args>(args)...));
  }
  /// The next word, without blanks and colons around it; empty at the end of the file.
  std::string_view next() {
    while (!rest_.empty() && (is_blank(rest_.front()) || rest_.front() == ':')) drop();
    std::size_t length = 0;
    while (length < rest_.size() && !is_blank(rest_[length]) && rest_[length] != ':') ++length;
    const std::string_view word = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return word;
  }
  /// What remains of the line, without the colon and blanks around it.
  std::string_view value() {
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end);
    while (!line.empty() && (is_blank(line.front()) || line.front() == ':')) line.remove_prefix(1);
    while (!line.empty() && is_blank(line.back())) line.remove_suffix(1);
    return line;
  }
  double number(std::string_view what) {
    const std::string_view word = next();
    const auto value = parse_number(word);
    if (!value) fail("{} is '{}', expected a number", what, shown(word));
    return *value;
  }
  std::size_t node(std::size_t dimension) {
    const std::string_view word = next();
    const auto value = parse_whole(word);
    if (!value || *value < 1 || *value > dimension)
      fail("node '{}', expected a number from 1 to {}", shown(word), dimension);
    return static_cast<std::size_t>(*value) - 1;
  }
  static std::string shown(std::string_view word) { return printable(word.substr(0, kMostShown)); }

 private:
  static bool is_blank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }
  void drop() {
    if (rest_.front() == '\n') ++line_;
    rest_.remove_prefix(1);
  }

  std::string_view rest_;
  const std::string& source_;
  int line_ = 1;
};

bool is_skipped(const std::string& keyword) {
  return keyword == "COMMENT" || keyword == "DISPLAY_DATA_TYPE" || keyword == "NODE_COORD_TYPE";
}

std::size_t read_dimension(Words& words) {
  const std::string_view text = words.value();
  const auto n = parse_whole(text);
  if (!n || *n < 1 || *n > kMostNodes)
    words.fail("DIMENSION is '{}', expected a number from 1 to {}", Words::shown(text), kMostNodes);
  return static_cast<std::size_t>(*n);
}

class Reader {
 public:
  Reader(std::string_view text, const std::string& source) : words_(text, source), source_(source) {}

  TsplibInstance read() {
    for (std::string keyword = upper(words_.next()); !keyword.empty() && keyword != "EOF";
         keyword = upper(words_.next()))
      take(keyword);
    if (!weights_) throw_invalid("{} has no EDGE_WEIGHT_TYPE, expected EUC_2D, CEIL_2D or EXPLICIT", source_);
    if (*weights_ == TsplibInstance::Weights::full_matrix ? instance_.matrix.empty() : instance_.points.empty())
      throw_invalid("{} has no {}", source_,
                    *weights_ == TsplibInstance::Weights::full_matrix ? "EDGE_WEIGHT_SECTION" : "NODE_COORD_SECTION");
    instance_.weights = *weights_;
    return std::move(instance_);
  }

 private:
  void take(const std::string& keyword) {
    if (keyword == "NAME") {
      instance_.name = printable(words_.value());
    } else if (keyword == "TYPE") {
      take_type(upper(words_.value()));
    } else if (keyword == "DIMENSION") {
      instance_.dimension = read_dimension(words_);
    } else if (keyword == "EDGE_WEIGHT_TYPE") {
      take_weights(upper(words_.value()));
    } else if (keyword == "EDGE_WEIGHT_FORMAT") {
      const std::string format = upper(words_.value());
      if (format != "FULL_MATRIX" && format != "FUNCTION")
        words_.fail("EDGE_WEIGHT_FORMAT is '{}', expected FULL_MATRIX", Words::shown(format));
    } else if (keyword == "NODE_COORD_SECTION") {
      take_points();
    } else if (keyword == "EDGE_WEIGHT_SECTION") {
      take_matrix();
    } else if (keyword == "DISPLAY_DATA_SECTION") {
      for (std::size_t k = 0; k < 3 * dimension(); ++k) words_.number("a coordinate");
    } else if (is_skipped(keyword)) {
      words_.value();
    } else {
      words_.fail(
          "'{}' is not a keyword that can be read; expected NAME, TYPE, DIMENSION, EDGE_WEIGHT_TYPE, "
          "EDGE_WEIGHT_FORMAT, NODE_COORD_SECTION, EDGE_WEIGHT_SECTION or EOF",
          Words::shown(keyword));
    }
  }
  void take_type(const std::string& type) {
    if (type != "TSP" && type != "ATSP" && type != "SOP")
      words_.fail("TYPE is '{}', expected TSP, ATSP or SOP", Words::shown(type));
    instance_.symmetric = type == "TSP", instance_.sequential = type == "SOP";
  }
  void take_weights(const std::string& weights) {
    using enum TsplibInstance::Weights;
    if (weights == "EUC_2D") {
      weights_ = euc_2d;
    } else if (weights == "CEIL_2D") {
      weights_ = ceil_2d;
    } else if (weights == "EXPLICIT") {
      weights_ = full_matrix;
    } else {
      words_.fail("EDGE_WEIGHT_TYPE is '{}', expected EUC_2D, CEIL_2D or EXPLICIT", Words::shown(weights));
    }
  }
  std::size_t dimension() const {
    if (instance_.dimension == 0) words_.fail("a section begins before DIMENSION, expected DIMENSION first");
    return instance_.dimension;
  }
  void take_points() {
    const std::size_t n = dimension();
    std::vector<bool> seen(n, false);
    instance_.points.resize(n);
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t i = words_.node(n);
      if (seen[i]) words_.fail("node {} has two positions, expected one", i + 1);
      seen[i] = true;
      const double x = words_.number("a coordinate"), y = words_.number("a coordinate");
      instance_.points[i] = {x, y};
    }
  }
  void take_matrix() {
    const std::size_t n = dimension();
    if (n > kMostMatrixNodes) words_.fail("a matrix of {} nodes, expected at most {}", n, kMostMatrixNodes);
    instance_.matrix.resize(n * n);
    double first = words_.number("an edge weight");
    // The matrix of a SOP begins with its size.
    if (instance_.sequential && first == static_cast<double>(n)) first = words_.number("an edge weight");
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        double& weight = instance_.matrix[i * n + j] = i + j == 0 ? first : words_.number("an edge weight");
        if (i == j) weight = 0;  // of no effect, and often written as a huge number
      }
    for (std::size_t j = 1; j < n && instance_.sequential; ++j)
      if (instance_.matrix[j] == kComesBefore) words_.fail("node {} comes before node 1, expected none", j + 1);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (instance_.symmetric && instance_.matrix[i * n + j] != instance_.matrix[j * n + i])
          words_.fail("the weight from {} to {} is {} and back {}, expected the same (or TYPE: ATSP)", j + 1, i + 1,
                      instance_.matrix[j * n + i], instance_.matrix[i * n + j]);
  }

  Words words_;
  const std::string& source_;
  TsplibInstance instance_;
  std::optional<TsplibInstance::Weights> weights_;
};

}  // namespace

std::unique_ptr<ConnectionCost> TsplibInstance::cost() const {
  if (weights == Weights::full_matrix && !sequential) return std::make_unique<MatrixCost>(dimension, matrix);
  if (weights == Weights::full_matrix) {
    std::vector<double> costs = matrix;
    std::ranges::replace(costs, kComesBefore, kForbidden);
    for (std::size_t i = 0; i < dimension; ++i) costs[i * dimension] = 0;
    return std::make_unique<MatrixCost>(dimension, std::move(costs));
  }
  return std::make_unique<RoundedCost>(points, weights == Weights::ceil_2d);
}

void TsplibInstance::require_order(TourProblem& problem) const {
  if (!sequential || matrix.empty()) return;
  for (ElementId i = 1; i < dimension; ++i)
    for (ElementId j = 1; j < dimension; ++j)
      if (matrix[i * dimension + j] == kComesBefore) problem.require_before(j, i);
}

TsplibInstance read_tsplib(std::string_view text, const std::string& source) { return Reader(text, source).read(); }

std::string write_tsplib(const TsplibInstance& instance) {
  const std::size_t n = instance.dimension;
  std::string out = fmt::format("NAME: {}\nTYPE: {}\nDIMENSION: {}\n", instance.name,
                                instance.sequential  ? "SOP"
                                : instance.symmetric ? "TSP"
                                                     : "ATSP",
                                n);
  if (instance.weights == TsplibInstance::Weights::full_matrix) {
    out += "EDGE_WEIGHT_TYPE: EXPLICIT\nEDGE_WEIGHT_FORMAT: FULL_MATRIX\nEDGE_WEIGHT_SECTION\n";
    if (instance.sequential) out += fmt::format("{}\n", n);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) out += to_decimal(instance.matrix[i * n + j]) + (j + 1 < n ? ' ' : '\n');
  } else {
    const bool up = instance.weights == TsplibInstance::Weights::ceil_2d;
    out += fmt::format("EDGE_WEIGHT_TYPE: {}\nNODE_COORD_SECTION\n", up ? "CEIL_2D" : "EUC_2D");
    for (std::size_t i = 0; i < n; ++i)
      out += fmt::format("{} {} {}\n", i + 1, to_decimal(instance.points[i].x()), to_decimal(instance.points[i].y()));
  }
  return out + "EOF\n";
}

std::vector<std::size_t> read_tsplib_tour(std::string_view text, const std::string& source) {
  Words words(text, source);
  std::size_t dimension = 0;
  for (std::string keyword = upper(words.next()); keyword != "TOUR_SECTION"; keyword = upper(words.next())) {
    if (keyword.empty()) throw_invalid("{} has no TOUR_SECTION", source);
    if (keyword == "DIMENSION")
      dimension = read_dimension(words);
    else
      words.value();
  }
  if (dimension == 0) words.fail("a section begins before DIMENSION, expected DIMENSION first");
  std::vector<std::size_t> order;
  std::vector<bool> seen(dimension, false);
  while (order.size() < dimension) {
    order.push_back(words.node(dimension));
    if (seen[order.back()]) words.fail("node {} comes twice in the tour, expected each once", order.back() + 1);
    seen[order.back()] = true;
  }
  if (const std::string_view end = words.next(); end != "-1" && !end.empty())
    words.fail("'{}' follows the {} nodes of the tour, expected -1", Words::shown(end), dimension);
  return order;
}

std::string write_tsplib_tour(const std::string& name, const std::vector<std::size_t>& order) {
  std::string out = fmt::format("NAME: {}\nTYPE: TOUR\nDIMENSION: {}\nTOUR_SECTION\n", name, order.size());
  for (const std::size_t node : order) out += fmt::format("{}\n", node + 1);
  return out + "-1\nEOF\n";
}

}  // namespace oxturn
