// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/atomic_file.hpp"

#include "particles/errors.hpp"
#include "particles/particle_file.hpp"
#include "particles/pvd_writer.hpp"
#include "particles/vtu_writer.hpp"
#include "sample_scene.hpp"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <functional>
#include <iterator>

namespace plenum {
namespace {

std::string contentOf(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string errorOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const RunError& error) {
    return error.what();
  }
  return "no error";
}

TEST(AtomicFile, AppearsOnlyWhenCommitted) {
  const TemporaryFolder folder;
  {
    AtomicFile file(folder / "a.txt");
    file.write("all of it");
    EXPECT_FALSE(std::filesystem::exists(folder / "a.txt"));
    EXPECT_EQ(file.temporaryPath().parent_path(), folder.path());
    file.commit();
  }
  EXPECT_EQ(contentOf(folder / "a.txt"), "all of it");
  EXPECT_EQ(folder.size(), 1u);
}

TEST(AtomicFile, LeavesTheOldFileWhenItFails) {
  const TemporaryFolder folder;
  writeTextFile(folder / "a.txt", "old");
  try {
    AtomicFile file(folder / "a.txt");
    file.write("half of");
    throw std::runtime_error("the writer's own failure");
  } catch (const std::runtime_error&) {
  }
  EXPECT_EQ(contentOf(folder / "a.txt"), "old");
  EXPECT_EQ(folder.size(), 1u);
}

TEST(AtomicFile, ErrorsNamePathReasonAndRemedy) {
  const TemporaryFolder folder;
  const std::string missing = errorOf([&] { AtomicFile file(folder / "none/a.txt"); });
  EXPECT_NE(missing.find("none/a.txt: cannot be written: no such folder"), std::string::npos);
  EXPECT_NE(missing.find("create the folder"), std::string::npos);
  EXPECT_NE(errorOf([&] { AtomicFile file(folder.path()); }).find("choose a file name"),
            std::string::npos);
  writeTextFile(folder / "file", "");
  EXPECT_NE(errorOf([&] { AtomicFile file(folder / "file/a.txt"); }).find("no such folder"),
            std::string::npos);
}

TEST(AtomicFile, ReadOnlyFolder) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  const TemporaryFolder folder;
  std::filesystem::permissions(
      folder.path(), std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  const std::string message = errorOf([&] { AtomicFile file(folder / "a.txt"); });
  std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_all);
  EXPECT_NE(message.find("choose a folder in which you may write"), std::string::npos) << message;
}

TEST(AtomicFile, ReasonsOfTheSystem) {
  EXPECT_NE(writeFailure("a.hdf", ENOSPC).find("free some space"), std::string::npos);
  EXPECT_NE(writeFailure("a.hdf", EROFS).find("choose a folder"), std::string::npos);
}

/// Starts `write` in a child and kills it as soon as its temporary file has some bytes.
void killWhileWriting(const TemporaryFolder& folder, const std::function<void()>& write) {
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    write();
    ::_exit(0);
  }
  bool begun = false;
  while (!begun) {
    for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
      std::error_code gone;
      const auto bytes = std::filesystem::file_size(entry, gone);
      begun = begun || (!gone && bytes > 0);
    }
    if (::waitpid(child, nullptr, WNOHANG) == child) FAIL() << "the child ended too early";
  }
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
}

TEST(KilledWriter, LeavesNoHalfParticleFile) {
  const TemporaryFolder folder;
  // 60 MB or so: enough that the kill hits the writing.
  const auto scene = sampleScene<3>(0, 1, 300000, 100000);
  killWhileWriting(folder, [&] { writeParticleFile(folder / "a.hdf", scene); });
  EXPECT_FALSE(std::filesystem::exists(folder / "a.hdf"));
  writeParticleFile(folder / "a.hdf", scene);  // what the killed one left does no harm
  EXPECT_EQ(readParticleFile<3>(folder / "a.hdf").particles.size(), 400000u);
}

TEST(KilledWriter, LeavesNoHalfTextFile) {
  const TemporaryFolder folder;
  killWhileWriting(folder, [&] {
    AtomicFile file(folder / "a.csv");
    for (;;) file.write("1, 2, 3\n");
  });
  EXPECT_FALSE(std::filesystem::exists(folder / "a.csv"));
}

TEST(VtuWriter, Errors) {
  const TemporaryFolder folder;
  EXPECT_THROW(writeVtu(folder / "a.vtu", ParticleSet<2>({FieldId::position}, 0, 0)), InputError);
  const ParticleSet<2> particles({FieldId::position}, 3, 0);
  EXPECT_THROW(writeVtu(folder / "a.vtu", particles, {.fields = FieldSet{FieldId::density}}),
               InputError);
  EXPECT_THROW(writeVtu(folder / "none/a.vtu", particles), RunError);
  EXPECT_EQ(folder.size(), 0u);
}

TEST(VtuWriter, WritesOnlyTheFieldsAskedFor) {
  const TemporaryFolder folder;
  const auto scene = sampleScene<2>();
  writeVtu(folder / "a.vtu", scene.particles, {.fields = FieldSet{FieldId::density}});
  const std::string content = contentOf(folder / "a.vtu");
  EXPECT_NE(content.find("Name=\"density\""), std::string::npos);
  EXPECT_NE(content.find("Name=\"type\""), std::string::npos);
  EXPECT_EQ(content.find("Name=\"velocity\""), std::string::npos);
}

TEST(PvdSeries, NamesFilesRelativeToItself) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "frames");
  PvdSeries series(folder / "run.pvd");
  series.add(0, folder / "frames/run_0000.vtu");
  series.add(0.1, folder / "frames/a&b.vtu");
  const std::string content = contentOf(folder / "run.pvd");
  EXPECT_NE(content.find("timestep=\"0\" part=\"0\" file=\"frames/run_0000.vtu\""),
            std::string::npos)
      << content;
  EXPECT_NE(content.find("timestep=\"0.1\" part=\"0\" file=\"frames/a&amp;b.vtu\""),
            std::string::npos)
      << content;
  EXPECT_EQ(series.size(), 2u);
}

TEST(PvdSeries, GoesOnAfterATime) {
  const TemporaryFolder folder;
  const auto run = folder / "run.pvd";
  PvdSeries whole(run), stopped(run), none(folder / "none.pvd");
  for (const double time : {0.0, 3 * 0.05, 0.2})
    whole.add(time, folder / fmt::format("{}&.vtu", time));
  const std::string content = contentOf(run);
  stopped.continueUntil(0.2 - 1e-12);
  EXPECT_EQ(stopped.size(), 2u);
  EXPECT_EQ(contentOf(run).find("0.2"), std::string::npos) << contentOf(run);
  stopped.add(0.2, folder / "0.2&.vtu");
  EXPECT_EQ(contentOf(run), content);

  none.continueUntil(1);
  EXPECT_EQ(none.size(), 0u);
  std::filesystem::resize_file(run, content.size() - 30);
  EXPECT_THROW(stopped.continueUntil(1), InputError);
}

}  // namespace
}  // namespace plenum
