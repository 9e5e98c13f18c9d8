// SPDX-License-Identifier: GPL-3.0-or-later
//
// Damaged and foreign particle files: each gets a one-line error that names the file and says what
// is wrong; none crashes. The damage is done with the HDF5 library itself.
#include "particles/errors.hpp"
#include "particles/hdf5.hpp"
#include "particles/particle_file.hpp"
#include "sample_scene.hpp"

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>

namespace plenum {
namespace {

std::string contentOf(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void write(const std::filesystem::path& path, std::string_view content) {
  std::ofstream(path, std::ios::binary) << content;
}

/// The message of the InputError that reading gives.
std::string errorOfReading(const std::filesystem::path& path) {
  try {
    withParticleFile(path, [](const auto&) {});
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_TRUE(message.starts_with(path.string() + ": ")) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    return message;
  }
  ADD_FAILURE() << path << " was read without an error";
  return "";
}

class DamagedFile : public testing::Test {
 protected:
  DamagedFile() { writeParticleFile(path_, sampleScene<2>()); }

  /// Applies `damage` to the open file and returns the message of reading it.
  std::string errorAfter(const std::function<void(hid_t file)>& damage) {
    const hid_t file = H5Fopen(path_.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    EXPECT_GE(file, 0);
    damage(file);
    H5Fclose(file);
    return errorOfReading(path_);
  }

  /// Replaces a dataset of /PartType0 by one of `n` doubles of value `value`.
  static void replace(hid_t file, const char* name, hsize_t n, double value = 1) {
    H5Ldelete(file, name, H5P_DEFAULT);
    const hid_t space = H5Screate_simple(1, &n, nullptr);
    const hid_t set =
        H5Dcreate2(file, name, H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    const std::vector<double> values(n, value);
    H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    H5Dclose(set);
    H5Sclose(space);
  }

  /// Sets the numbers of an attribute of /Plenum.
  template <class T>
  static void setAttribute(hid_t file, const char* name, T value) {
    const hid_t group = H5Gopen2(file, "Plenum", H5P_DEFAULT);
    const hid_t attribute = H5Aopen(group, name, H5P_DEFAULT);
    EXPECT_GE(H5Awrite(attribute, hdf5::typeOf<T>(), &value), 0);
    H5Aclose(attribute);
    H5Gclose(group);
  }

  TemporaryFolder folder_;
  std::filesystem::path path_ = folder_ / "particles.hdf";
};

#define EXPECT_SAYS(message, part) \
  EXPECT_NE((message).find(part), std::string::npos) << "it says: " << (message)

TEST_F(DamagedFile, TruncatedAtAnyLengthIsAnError) {
  const std::string whole = contentOf(path_);
  const std::filesystem::path cut = folder_ / "cut.hdf";
  int truncated = 0;
  // Every byte of the first part (superblock, headers), then in steps that hit all kinds of blocks.
  for (std::size_t n = 0; n < whole.size(); n += n < 600 ? 1 : 397) {
    write(cut, std::string_view(whole).substr(0, n));
    const std::string message = errorOfReading(cut);
    truncated += message.find("truncated") != std::string::npos ? 1 : 0;
  }
  EXPECT_GT(truncated, 100);
}

TEST_F(DamagedFile, FlippedBytesNeverCrash) {
  const std::string whole = contentOf(path_);
  const std::filesystem::path flipped = folder_ / "flipped.hdf";
  for (std::size_t at = 0; at < whole.size(); at += at < 3000 ? 7 : 991) {
    std::string content = whole;
    content[at] = static_cast<char>(content[at] ^ 0x5a);
    write(flipped, content);
    try {
      withParticleFile(flipped, [](const auto&) {});
    } catch (const InputError&) {
    }  // a flip inside a number may well give another valid file
  }
}

TEST_F(DamagedFile, MissingFileFolderAndOtherKinds) {
  EXPECT_SAYS(errorOfReading(folder_ / "none.hdf"), "no such particle file");
  EXPECT_SAYS(errorOfReading(folder_.path()), "not a file");
  write(folder_ / "case.toml", "spacing = 0.1\n");
  EXPECT_SAYS(errorOfReading(folder_ / "case.toml"), "not an HDF5 file");
  EXPECT_SAYS(errorOfReading(folder_ / "case.toml"), "plenum-ic generate");
  write(folder_ / "empty.hdf", "");
  EXPECT_SAYS(errorOfReading(folder_ / "empty.hdf"), "not an HDF5 file");
}

TEST_F(DamagedFile, OtherSchemaVersion) {
  const auto message =
      errorAfter([](hid_t file) { setAttribute<std::int32_t>(file, "SchemaVersion", 99); });
  EXPECT_SAYS(message, "has schema version 99, this program reads version 1");
}

TEST_F(DamagedFile, FilesOfOtherPrograms) {
  EXPECT_SAYS(errorAfter([](hid_t file) { H5Ldelete(file, "Plenum", H5P_DEFAULT); }),
              "a GADGET or SWIFT file without /Plenum");
  EXPECT_SAYS(errorAfter([](hid_t file) { H5Ldelete(file, "PartType0", H5P_DEFAULT); }),
              "an HDF5 file of another program");
}

TEST_F(DamagedFile, MissingDatasets) {
  for (const char* name :
       {"PartType0/Velocities", "PartType0/MaterialIDs", "PartType0/ParticleTypes", "VTKHDF/Points",
        "Plenum/CaseText", "Plenum/Walls/Thickness", "Plenum/Container/Counts",
        "Plenum/Quality/Value", "Plenum/Materials/Density", "PartType0", "VTKHDF"}) {
    writeParticleFile(path_, sampleScene<2>());
    EXPECT_SAYS(errorAfter([&](hid_t file) { H5Ldelete(file, name, H5P_DEFAULT); }),
                std::string("/") + name + " is missing");
  }
}

TEST_F(DamagedFile, MissingAttribute) {
  EXPECT_SAYS(
      errorAfter([](hid_t file) { H5Adelete_by_name(file, "Plenum", "Spacing", H5P_DEFAULT); }),
      "/Plenum lacks the attribute Spacing");
}

TEST_F(DamagedFile, MotionsWithoutSense) {
  const auto errorOf = [&](const std::function<void(RigidMotion&)>& change) {
    auto scene = sampleScene<2>();
    change(scene.info.walls[1].motion);
    writeParticleFile(path_, scene);
    return errorOfReading(path_);
  };
  EXPECT_SAYS(errorOf([](RigidMotion& m) { m.oscillation.harmonic.ramp = 5; }),
              "/Plenum/Walls gives wall \"housing\" a ramp of 5 s from 1 s until 9 s");
  EXPECT_SAYS(errorOf([](RigidMotion& m) { m.table.times[2] = 0; }), "a table with 0 s after 0 s");
  EXPECT_SAYS(errorOf([](RigidMotion& m) {
                m.axis = {1, 1, 1};
              }),
              "an axis that is no unit vector");
  writeParticleFile(path_, sampleScene<2>());
  EXPECT_SAYS(errorAfter([](hid_t file) { replace(file, "Plenum/Walls/TableTime", 4); }),
              "/Plenum/Walls/TableTime is no list of the 5 rows that TableRows counts");
  for (const char* name : {"RockingSignal", "OscillationSignal", "TablePlace"}) {
    writeParticleFile(path_, sampleScene<2>());
    const std::string path = std::string("Plenum/Walls/") + name;
    EXPECT_SAYS(errorAfter([&](hid_t file) { H5Ldelete(file, path.c_str(), H5P_DEFAULT); }),
                path + " is missing");
  }
}

TEST_F(DamagedFile, AFileOfAnEarlierVersionHasConstantMotionsOnly) {
  const hid_t file = H5Fopen(path_.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  for (const char* name : {"Axis", "OscillationAmplitude", "OscillationSignal", "RockingAmplitude",
                           "RockingSignal", "TableRows", "TableTime", "TablePlace"})
    EXPECT_GE(H5Ldelete(file, (std::string("Plenum/Walls/") + name).c_str(), H5P_DEFAULT), 0);
  EXPECT_GE(H5Adelete_by_name(file, "Plenum", "StartTime", H5P_DEFAULT), 0);
  H5Fclose(file);
  const SceneInfo<2> info = readParticleFile<2>(path_).info;
  EXPECT_EQ(info.startTime, info.time);
  const RigidMotion& shaft = info.walls[0].motion;
  EXPECT_TRUE(shaft == (RigidMotion{{0, 0, 0}, {0, 0, 104.7}, {0.1, 0.2, 0.3}}));
  EXPECT_TRUE(info.walls[1].motion.isStill());
}

TEST_F(DamagedFile, LengthsThatDisagree) {
  EXPECT_SAYS(errorAfter([](hid_t file) { replace(file, "PartType0/Masses", 49); }),
              "/PartType0/Masses has the shape (49), must have (50)");
  writeParticleFile(path_, sampleScene<2>());
  EXPECT_SAYS(errorAfter([](hid_t file) { replace(file, "Plenum/Walls/Density", 3); }),
              "/Plenum/Walls/Density has the shape (3), must have (2)");
  writeParticleFile(path_, sampleScene<2>());
  EXPECT_SAYS(
      errorAfter([](hid_t file) { setAttribute<std::uint64_t>(file, "NumberOfWalls", 14); }),
      "50 rows, /Plenum says 37 fluid and 14 wall particles");
  writeParticleFile(path_, sampleScene<2>());
  EXPECT_SAYS(errorAfter([](hid_t file) { replace(file, "VTKHDF/Points", 50); }),
              "is not a list of points with three coordinates");
}

TEST_F(DamagedFile, HugeNumberOfParticlesIsNotAllocated) {
  EXPECT_SAYS(errorAfter([](hid_t file) {
                setAttribute<std::uint64_t>(file, "NumberOfFluids", std::uint64_t{1} << 60);
              }),
              "50 rows");
}

TEST_F(DamagedFile, ValuesThatAreNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_SAYS(errorAfter([&](hid_t file) { replace(file, "PartType0/Masses", 50, nan); }),
              "mass of fluid particle 0 (id 50) is not finite");
  writeParticleFile(path_, sampleScene<2>());
  const auto message = errorAfter([&](hid_t file) {
    const hid_t set = H5Dopen2(file, "VTKHDF/Points", H5P_DEFAULT);
    std::vector<double> points(150, 0.5);
    points[3 * 40 + 1] = std::numeric_limits<double>::infinity();
    H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, points.data());
    H5Dclose(set);
  });
  EXPECT_SAYS(message, "position of wall particle 40 (id 10) is not finite");
}

TEST_F(DamagedFile, LabelsOfNothing) {
  auto scene = sampleScene<2>();
  scene.particles[field::wall][5] = 2;
  writeParticleFile(path_, scene);
  EXPECT_SAYS(errorOfReading(path_),
              "/PartType0/WallIDs has the value 2, /Plenum/Walls has 2 rows");
}

TEST_F(DamagedFile, ParticleTypesOutOfOrder) {
  EXPECT_SAYS(errorAfter([](hid_t file) {
                const hid_t set = H5Dopen2(file, "PartType0/ParticleTypes", H5P_DEFAULT);
                const std::vector<std::uint8_t> types(50, 1);
                H5Dwrite(set, H5T_NATIVE_UINT8, H5S_ALL, H5S_ALL, H5P_DEFAULT, types.data());
                H5Dclose(set);
              }),
              "ParticleTypes does not list fluids (0) first");
}

TEST(WritingParticleFile, RefusesWhatHasNoMeaning) {
  const TemporaryFolder folder;
  auto scene = sampleScene<2>();
  scene.particles[field::position][3][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(writeParticleFile(folder / "a.hdf", scene), RunError);
  EXPECT_THROW(writeParticleFile(folder / "a.hdf", Scene<2>{}), InputError);
  auto periodic = sampleScene<2>();
  periodic.info.domain = {};
  periodic.info.domain.periodic[1] = true;
  EXPECT_THROW(writeParticleFile(folder / "a.hdf", periodic), InputError);
  EXPECT_EQ(folder.size(), 0u);
}

TEST(WritingParticleFile, KeepsAFailedStateForInspection) {
  const TemporaryFolder folder;
  auto scene = sampleScene<2>();
  scene.particles[field::velocity][3][1] = std::numeric_limits<double>::quiet_NaN();
  writeParticleFile(folder / "a.hdf", scene);
  EXPECT_SAYS(errorOfReading(folder / "a.hdf"), "velocity of fluid particle 3 (id 47)");
}

TEST(WritingParticleFile, NoSuchFolder) {
  const TemporaryFolder folder;
  try {
    writeParticleFile(folder / "none/a.hdf", sampleScene<2>());
    FAIL() << "was written";
  } catch (const RunError& error) {
    EXPECT_SAYS(std::string(error.what()), "a.hdf: cannot be written: no such folder");
    EXPECT_SAYS(std::string(error.what()), "create the folder first");
  }
}

/// A limit on file sizes stands for a full disk: the kernel refuses to write in the same way.
TEST(WritingParticleFile, FullDiskLeavesTheOldFileAndNothingElse) {
  const TemporaryFolder folder;
  const auto path = folder / "a.hdf";
  writeParticleFile(path, sampleScene<2>());
  const std::string old = contentOf(path);
  const auto previous = std::signal(SIGXFSZ, SIG_IGN);
  rlimit limit{};
  getrlimit(RLIMIT_FSIZE, &limit);
  for (rlim_t bytes : {0u, 100u, 5000u, 200000u, 1000000u}) {
    const rlimit small{bytes, limit.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
    std::string message;
    try {
      writeParticleFile(path, sampleScene<3>(0, 1, 20000, 5000));
    } catch (const RunError& error) {
      message = error.what();
    }
    setrlimit(RLIMIT_FSIZE, &limit);
    EXPECT_SAYS(message, "a.hdf: cannot be written: ");
    EXPECT_EQ(folder.size(), 1u);
    EXPECT_EQ(contentOf(path), old);
  }
  std::signal(SIGXFSZ, previous);
}

}  // namespace
}  // namespace plenum
