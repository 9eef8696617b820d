#include "base/parameters.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "base/text.hpp"
#include "tests/support/files.hpp"

namespace oxturn {
namespace {

struct Params {
  bool diagonal = false;
  int teeth = 8;
  double cell_size = 0.5;
  std::string order = "nearest";
};

std::vector<Parameter<Params>> lines() {
  return {{"diagonal", &Params::diagonal, "also step diagonally"},
          {"teeth", &Params::teeth, Range{1, 100}, "how many"},
          {"cell_size", &Params::cell_size, Range{0, 10}, "metres"},
          {"order", &Params::order, Choices{"nearest", "improved"}, "next piece"}};
}

Params with(const Settings& settings) { return with_settings<Params>("planner 'x'", lines(), settings); }
std::string error_for(const Settings& settings) {
  return complaint([&] { with(settings); });
}

TEST(Parameters, FallbacksAreTheDefaultsOfTheStruct) {
  const auto infos = infos_of(lines());
  ASSERT_EQ(infos.size(), 4u);
  EXPECT_EQ(infos[0].fallback, Value(false));
  EXPECT_EQ(infos[1].fallback, Value(std::int64_t{8}));
  EXPECT_EQ(infos[2].fallback, Value(0.5));
  EXPECT_EQ(infos[3].fallback, Value(std::string("nearest")));
}

TEST(Parameters, SettingsOverwriteDefaults) {
  const Params p =
      with({{"teeth", std::int64_t{3}}, {"cell_size", std::int64_t{2}}, {"order", std::string("improved")}});
  EXPECT_FALSE(p.diagonal);
  EXPECT_EQ(p.teeth, 3);
  EXPECT_EQ(p.cell_size, 2.0);  // a whole number is accepted for a real
  EXPECT_EQ(p.order, "improved");
}

TEST(Parameters, ErrorsNameParameterOwnerAndWhatIsExpected) {
  EXPECT_EQ(error_for({{"cel_size", 1.0}}),
            "unknown parameter 'cel_size' of planner 'x'; it has: diagonal, teeth, cell_size, order");
  EXPECT_EQ(error_for({{"teeth", std::int64_t{0}}}),
            "parameter 'teeth' of planner 'x' is 0, expected a whole number from 1 to 100");
  EXPECT_EQ(error_for({{"teeth", 2.5}}),
            "parameter 'teeth' of planner 'x' is 2.5, expected a whole number from 1 to 100");
  EXPECT_EQ(error_for({{"teeth", 2.0}}),
            "parameter 'teeth' of planner 'x' is 2.0, expected a whole number from 1 to 100");
  EXPECT_EQ(error_for({{"cell_size", 11.0}}),
            "parameter 'cell_size' of planner 'x' is 11, expected a number from 0 to 10");
  EXPECT_EQ(error_for({{"cell_size", std::nan("")}}),
            "parameter 'cell_size' of planner 'x' is nan, expected a finite number");
  EXPECT_EQ(error_for({{"cell_size", std::string("1")}}),
            "parameter 'cell_size' of planner 'x' is '1', expected a number from 0 to 10");
  EXPECT_EQ(error_for({{"diagonal", std::int64_t{1}}}),
            "parameter 'diagonal' of planner 'x' is 1, expected true or false");
  EXPECT_EQ(error_for({{"order", std::string("far")}}),
            "parameter 'order' of planner 'x' is 'far', expected one of: nearest, improved");
}

TEST(Parameters, YesAndNoMayBeAmongChoices) {
  const ParameterInfo outline{"outline", std::string("true"), {}, {"false", "needed", "true"}, ""};
  EXPECT_EQ(checked("x", outline, Value(false)), Value(std::string("false")));
  EXPECT_EQ(parse_value("x", outline, "on"), Value(std::string("true")));
  EXPECT_EQ(parse_value("x", outline, "needed"), Value(std::string("needed")));
  const ParameterInfo order{"order", std::string("near"), {}, {"near", "far"}, ""};
  EXPECT_THROW(checked("x", order, Value(true)), std::invalid_argument);
  EXPECT_THROW(parse_value("x", order, "on"), std::invalid_argument);
}

TEST(Parameters, WholeNumbersThatDoNotFitAnIntAreRefused) {
  const ParameterInfo unbounded{"n", std::int64_t{1}, {}, {}, ""};
  EXPECT_THROW(checked("x", unbounded, std::int64_t{1} << 40), std::invalid_argument);
  EXPECT_THROW(parse_value("x", unbounded, "99999999999999999999"), std::invalid_argument);
}

TEST(Parameters, TextsAreParsedAsTheParametersType) {
  const auto infos = infos_of(lines());
  const auto read = [&](std::size_t i, const char* text) { return parse_value("x", infos[i], text); };
  EXPECT_EQ(read(0, "true"), Value(true));
  EXPECT_EQ(read(0, "off"), Value(false));
  EXPECT_EQ(read(1, "+12"), Value(std::int64_t{12}));
  EXPECT_EQ(read(2, "1e-3"), Value(0.001));
  EXPECT_EQ(read(3, "improved"), Value(std::string("improved")));
  for (const char* bad : {"", " ", "1 ", "x", "1,5", "0x10", "--1", "+-1"}) {
    SCOPED_TRACE(bad);
    EXPECT_THROW(read(1, bad), std::invalid_argument);
    EXPECT_THROW(read(2, bad), std::invalid_argument);
  }
  EXPECT_THROW(read(2, "nan"), std::invalid_argument);
  EXPECT_THROW(read(2, "inf"), std::invalid_argument);
  EXPECT_THROW(read(0, "maybe"), std::invalid_argument);
}

TEST(Parameters, TextOfAValueIsParsedBackToIt) {
  const ParameterInfo real{"r", 1.0, {}, {}, ""};
  for (const double d : {0.1, 1.0 / 3, 1e300, 5e-324, -2.0, 0.35})
    EXPECT_EQ(parse_value("x", real, to_text(d)), Value(d));
  EXPECT_EQ(to_text(Value(0.35)), "0.35");
  EXPECT_EQ(to_text(Value(-0.0)), "0");
  EXPECT_EQ(to_text(Value(true)), "true");
}

}  // namespace
}  // namespace oxturn
