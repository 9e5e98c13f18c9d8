// SPDX-License-Identifier: GPL-3.0-or-later
//
// Case files: values with their lines, and errors that name line, key, value, range and remedy.
#include "particles/case_node.hpp"
#include "particles/case_settings.hpp"
#include "particles/errors.hpp"
#include "particles/section.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>

namespace plenum {
namespace {

std::string errorOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

#define EXPECT_SAYS(message, part) EXPECT_NE((message).find(part), std::string::npos) << (message)

const std::string minimal = R"(title = "box"
dimension = 2
spacing = 0.05
fluid = [{ region = "box" }]
)";

std::string errorOfCase(const std::string& text) {
  return errorOf([&] { readCase(CaseNode::parse(text, "case.toml")); });
}

TEST(CaseNode, KeepsTypesLinesAndOrder) {
  const CaseNode root = CaseNode::parse("b = 1\na = 2.5\nc = [true, \"x\"]\n[t]\nd = -7\n", "f");
  ASSERT_EQ(root.asTable().size(), 4u);
  EXPECT_EQ(root.asTable()[0].first, "b");
  EXPECT_EQ(root.find("b")->asInteger(), 1);
  EXPECT_EQ(root.find("b")->asNumber(), 1.0);
  EXPECT_EQ(root.find("a")->asNumber(), 2.5);
  EXPECT_EQ(root.find("c")->asArray()[1].asString(), "x");
  EXPECT_EQ(root.find("c")->asArray()[1].path(), "c[1]");
  EXPECT_EQ(root.find("t")->find("d")->path(), "t.d");
  EXPECT_EQ(root.find("t")->find("d")->line(), 5);
  EXPECT_EQ(root.find("nothing"), nullptr);
  EXPECT_EQ(root.find("c")->printed(), "[true, \"x\"]");
}

TEST(CaseNode, WrongTypesNameWhatIsThereAndWhatMustBe) {
  const CaseNode root = CaseNode::parse("a = 1\ns = \"text\"\n", "f.toml");
  EXPECT_EQ(errorOf([&] { root.find("s")->asNumber(); }),
            "f.toml:2: s = \"text\": is a string, must be a number");
  EXPECT_EQ(errorOf([&] { root.find("a")->asString(); }),
            "f.toml:1: a = 1: is an integer, must be a string");
  EXPECT_SAYS(errorOf([&] { root.find("a")->asBool(); }), "must be true or false");
  EXPECT_SAYS(errorOf([&] { root.find("a")->asTable(); }), "must be a table");
}

TEST(CaseNode, NotToml) {
  EXPECT_SAYS(errorOf([] { CaseNode::parse("a = 1\nb = = 2\n", "f.toml"); }),
              "f.toml:2: not valid TOML");
}

TEST(CaseNode, FilesThatAreNotCaseFiles) {
  namespace fs = std::filesystem;
  EXPECT_SAYS(errorOf([] { CaseNode::load("no/such.toml"); }), "no such case file");
  EXPECT_SAYS(errorOf([] { CaseNode::load(fs::temp_directory_path()); }), "not a file");
  const fs::path path = fs::temp_directory_path() / "plenum_case_file_test.hdf";
  std::ofstream(path) << "\x89HDF\r\n";
  const std::string message = errorOf([&] { CaseNode::load(path); });
  fs::remove(path);
  EXPECT_SAYS(message, "is a particle file");
}

TEST(CaseNode, SetOnTheCommandLine) {
  CaseNode root = CaseNode::parse("[solver]\nkernel = \"convex\"\n", "f.toml");
  root.set("solver.kernel", "wendland_c2");  // bare words are strings
  root.set("solver.end_time", "2.5");
  root.set("output.fields", "[\"density\"]");
  root.set("new.deep.key", "true");
  root.set("solver.cfl", ".05");  // no number in TOML, but in all that people write
  EXPECT_EQ(root.find("solver")->find("kernel")->asString(), "wendland_c2");
  EXPECT_EQ(root.find("solver")->find("end_time")->asNumber(), 2.5);
  EXPECT_EQ(root.find("output")->find("fields")->asArray()[0].asString(), "density");
  EXPECT_EQ(root.find("solver")->find("cfl")->asNumber(), 0.05);
  EXPECT_TRUE(root.find("new")->find("deep")->find("key")->asBool());
}

TEST(CaseNode, TakesKeysAndEntriesOfListsOut) {
  CaseNode root =
      CaseNode::parse("a = 1\n[b]\nc = { d = 2, e = 3 }\n[[f]]\ng = 4\n[[f]]\ng = 5\n", "x");
  for (const char* missing : {"z", "a.z", "b.z.d", "f[2]", "a[0]"}) root.remove(missing);
  root.remove("b.c.d");
  root.remove("f[0]");
  root.remove("a");
  EXPECT_EQ(root.printed(), "{ b = { c = { e = 3 } }, f = [{ g = 5 }] }");
}

/// Also keys that need quotation marks, and lists of tables between other things.
TEST(CaseNode, IsTheSameFromWhatItPrints) {
  const CaseNode root =
      CaseNode::parse("[t]\n\"a.b\" = 1.5\nlist = [1, 2]\n[[l]]\nx = \"q\\\"\"\n[[l]]\n[u]\n", "x");
  CaseNode changed = root;
  changed.set("late", "true");  // stands behind tables, but not in one of them
  const CaseNode again = CaseNode::parse(changed.printedFile("comment"), "y");
  EXPECT_TRUE(again.find("late")->asBool());
  EXPECT_EQ(again.find("t")->printed(), root.find("t")->printed());
  EXPECT_EQ(again.find("l")->printed(), root.find("l")->printed());
  EXPECT_TRUE(again.find("u")->isTable());
}

TEST(CaseNode, ErrorsOfSetNameTheOption) {
  CaseNode root = CaseNode::parse(minimal, "f.toml");
  root.set("spacing", "-1");
  EXPECT_SAYS(errorOf([&] { readCase(root); }), "--set spacing=-1: spacing = -1: must be > 0 [m]");
  EXPECT_SAYS(errorOf([&] { root.set("spacing.x", "1"); }), "is not a table");
  EXPECT_SAYS(errorOf([&] { root.set("solver..x", "1"); }), "an empty key");
}

TEST(Case, DefaultsAndValues) {
  const CaseSettings plain = readCase(CaseNode::parse(minimal, "case.toml"));
  EXPECT_EQ(plain.spacing, 0.05);
  EXPECT_FALSE(plain.solver.has_value());
  EXPECT_EQ(plain.solverOrDefaults().kernel, "wendland_c2");
  const CaseSettings full = readCase(CaseNode::parse(minimal + R"(
[solver]
kernel = "convex"
gravity = [0, -9.81]
viscosity = { monaghan = { alpha = 0.2 } }
)",
                                                     "case.toml"));
  EXPECT_EQ(full.solver->kernel, "convex");
  EXPECT_EQ(full.solver->gravity, (std::vector<double>{0, -9.81}));
  EXPECT_EQ(full.solver->viscosity->monaghan->alpha, 0.2);
  EXPECT_EQ(full.solver->viscosity->monaghan->beta, 0);
  EXPECT_FALSE(full.solver->collisions.has_value());
}

TEST(Case, UnknownKeysNameLineAndNearestKey) {
  EXPECT_EQ(errorOfCase(minimal + "spaceing = 1\n"),
            "case.toml:5: spaceing = 1: unknown key 'spaceing'; did you mean 'spacing'?");
  EXPECT_SAYS(errorOfCase(minimal + "[solver]\nsmoothing_lenght = 2\n"),
              "case.toml:6: solver.smoothing_lenght = 2: unknown key 'smoothing_lenght'; did you "
              "mean 'smoothing_length'?");
  EXPECT_SAYS(errorOfCase(minimal + "[solver.viscosity.monaghan]\nqqqqqqqq = 2\n"),
              "known here: alpha, beta");
}

TEST(Case, RangesChoicesAndTypes) {
  EXPECT_SAYS(errorOfCase(minimal + "[solver]\nsmoothing_length = 99\n"),
              "case.toml:6: solver.smoothing_length = 99: must be in [0.6, 6] [d_ref]");
  EXPECT_SAYS(errorOfCase(minimal + "[solver]\nsmoothing_length = nan\n"), "finite number");
  EXPECT_SAYS(errorOfCase(minimal + "[solver]\nsmoothing_length = \"big\"\n"),
              "is a string, must be a number");
  EXPECT_SAYS(errorOfCase(minimal + "[solver]\nkernel = \"convexe\"\n"),
              "did you mean \"convex\"?");
  EXPECT_SAYS(errorOfCase(minimal + "[solver]\ngravity = [0, 0, -9.81]\n"),
              "has 3 components, the case has 2 dimensions");
  EXPECT_SAYS(errorOfCase(minimal + "[domain]\nlower = [0, 0]\nupper = [1, 0]\n"),
              "upper must be above lower");
  EXPECT_SAYS(errorOfCase("dimension = 4\nspacing = 1\nfluid = []\n"), "dimension = 4");
}

TEST(Case, MissingKeys) {
  EXPECT_SAYS(errorOfCase("title = \"x\"\nfluid = []\n"), "the key 'spacing' is missing");
  EXPECT_SAYS(errorOfCase("spacing = 1\n"), "the key 'fluid' is missing");
  EXPECT_SAYS(errorOfCase(minimal + "[domain]\nlower = [0, 0]\n"), "the key 'upper' is missing");
}

struct Toy {
  double size = 1.5;
  int count = 3;
  bool on = true;
  std::string mode = "slow";
  std::vector<std::string> axes;
};

Section<Toy> toySection() {
  Section<Toy> section("a toy");
  section.number("size", &Toy::size, "m", Range::above(0, 2), "its size")
      .integer("count", &Toy::count, Range::between(1, 9), "how many")
      .flag("on", &Toy::on, "whether it runs")
      .text("mode", &Toy::mode, "how it runs", {"slow", "fast"})
      .texts("axes", &Toy::axes, "where it runs", {"x", "y"});
  return section;
}

TEST(Section, ReadsEveryType) {
  const Toy toy = toySection().read(
      CaseNode::parse("size = 2\ncount = 9\non = false\nmode = \"fast\"\naxes = [\"y\"]\n", "f"),
      2);
  EXPECT_EQ(toy.size, 2);
  EXPECT_EQ(toy.count, 9);
  EXPECT_FALSE(toy.on);
  EXPECT_EQ(toy.mode, "fast");
  EXPECT_EQ(toy.axes, std::vector<std::string>{"y"});
  EXPECT_EQ(toySection().read(CaseNode::parse("", "f"), 2).count, 3);
}

TEST(Section, BoundsAreAsDeclared) {
  const auto read = [](const std::string& text) {
    return errorOf([&] { toySection().read(CaseNode::parse(text, "f"), 2); });
  };
  EXPECT_EQ(read("size = 2.0"), "no error");
  EXPECT_SAYS(read("size = 0"), "must be in (0, 2] [m]");
  EXPECT_EQ(read("count = 1"), "no error");
  EXPECT_SAYS(read("count = 10"), "must be in [1, 9]");
  EXPECT_SAYS(read("count = 1.0"), "is a number, must be an integer");
  EXPECT_SAYS(read("axes = [\"z\"]"), "must be one of x | y");
}

struct Flock {
  std::vector<Toy> toys;
  std::vector<double> weights;
};

Section<Flock> flockSection() {
  Section<Flock> section("several toys");
  section.sections("toy", &Flock::toys, toySection())
      .list("weights", &Flock::weights, "kg", Range::positive(), "what they weigh")
      .condition([](const Flock& flock, const CaseNode& table, int) {
        if (flock.weights.size() != flock.toys.size()) table.fail("needs a weight for each toy");
      });
  return section;
}

TEST(Section, ListsOfTablesAndOfNumbers) {
  const auto read = [](const std::string& text) {
    return flockSection().read(CaseNode::parse(text, "f"), 2);
  };
  const Flock flock = read("weights = [1, 2.5]\n[[toy]]\nsize = 1\n[[toy]]\ncount = 4\n");
  ASSERT_EQ(flock.toys.size(), 2u);
  EXPECT_EQ(flock.toys[0].size, 1);
  EXPECT_EQ(flock.toys[1].count, 4);
  EXPECT_EQ(flock.weights, (std::vector{1, 2.5}));
  EXPECT_TRUE(read("").toys.empty());
  const auto error = [&](const std::string& text) { return errorOf([&] { read(text); }); };
  EXPECT_SAYS(error("[[toy]]\n[[toy]]\ncuont = 4\n"), "did you mean 'count'?");
  EXPECT_SAYS(error("[[toy]]\n[[toy]]\ncount = 10\n"), "f:3: toy[1].count = 10: must be in");
  EXPECT_SAYS(error("toy = 3"), "is an integer, must be a list");
  EXPECT_SAYS(error("toy = [3]"), "is an integer, must be a table");
  EXPECT_SAYS(error("weights = [1, 0]\n"), "weights[1] = 0: must be > 0 [kg]");
  EXPECT_SAYS(error("weights = [1]\n"), "f:1: needs a weight for each toy");
  const SectionDoc doc = flockSection().doc("flock");
  EXPECT_SAYS(doc.markdown(), "### `[[flock.toy]]`");
  EXPECT_SAYS(doc.printed(), "[[toy]]  ");
}

TEST(Quick, SetsWhatTheTableSays) {
  const std::string text =
      "spacing = 0.1\n[solver]\nend_time = 2\n[[validate]]\nat_most = 1\n"
      "[quick]\n\"solver.end_time\" = 0.5\nspacing = 0.2\n\"validate[0].at_most\" = 3\n";
  const auto changed = [&](bool quick, const std::vector<std::string>& assignments) {
    CaseNode root = CaseNode::parse(text, "f");
    applyChanges(root, quick, assignments);
    return std::vector{root.find("spacing")->asNumber(),
                       root.find("solver")->find("end_time")->asNumber(),
                       root.find("validate")->asArray()[0].find("at_most")->asNumber()};
  };
  EXPECT_EQ(changed(false, {}), (std::vector{0.1, 2.0, 1.0}));
  EXPECT_EQ(changed(true, {}), (std::vector{0.2, 0.5, 3.0}));
  EXPECT_EQ(changed(true, {"spacing=0.4"}), (std::vector{0.4, 0.5, 3.0})) << "--set comes last";
  CaseNode none = CaseNode::parse("spacing = 0.1", "f");
  EXPECT_SAYS(errorOf([&] { applyChanges(none, true, {}); }), "f: has no table [quick]");
}

TEST(Section, HelpAndDocsNameEveryKey) {
  for (const std::string& text :
       {toySection().doc("toy").printed(), toySection().doc("toy").markdown()})
    for (const char* part : {"size", "count", "on", "mode", "axes", "its size", "1.5", "(0, 2]"})
      EXPECT_SAYS(text, part);
  EXPECT_SAYS(caseSection().doc("case").printed(), "smoothing_length");
}

}  // namespace
}  // namespace plenum
