#include <iterator>

#include <gtest/gtest.h>

#include <libhair/files/atomic_write.h>
#include <libhair/files/byte_reader.h>

#include "samples.h"

namespace hair {
namespace {

namespace fs = std::filesystem;

std::size_t fileCount(const TemporaryFolder& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()));
}

TEST(AtomicWrite, AFailureLeavesTheOldFileAndNothingElse) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("a.txt", "old");
  const auto failing = [&] {
    writeAtomically(file, [](std::ostream& out) {
      out << "half of the new one";
      throw Error("no more");
    });
  };
  EXPECT_EQ(errorOf(failing), "no more");
  EXPECT_EQ(readWholeFile(file), "old");
  EXPECT_EQ(fileCount(folder), 1u);
  EXPECT_NE(errorOf([&] {
              writeAtomically(file, [](std::ostream& out) { out.setstate(std::ios::badbit); });
            }).find("cannot write"),
            std::string::npos);
  EXPECT_EQ(readWholeFile(file), "old");
  EXPECT_EQ(fileCount(folder), 1u);
}

TEST(AtomicWrite, TheNewFileReplacesTheOldAtOnce) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("a.txt", "old");
  writeAtomically(file, [&](std::ostream& out) {
    out << "new" << std::flush;
    EXPECT_EQ(readWholeFile(file), "old");
  });
  EXPECT_EQ(readWholeFile(file), "new");
  EXPECT_EQ(fileCount(folder), 1u);
}

TEST(AtomicWrite, TheTemporaryPathKeepsFolderAndExtension) {
  const TemporaryFolder folder;
  writePathAtomically(folder / "a.png", [&](const fs::path& path) {
    EXPECT_EQ(path.extension(), ".png");
    EXPECT_EQ(path.parent_path(), folder.path());
    EXPECT_FALSE(fs::exists(folder / "a.png"));
    std::ofstream(path) << "picture";
  });
  EXPECT_EQ(readWholeFile(folder / "a.png"), "picture");
}

TEST(AtomicWrite, LinksAndRightsStay) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("a.txt", "old");
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("a.txt", folder / "link.txt");
  writeAtomically(folder / "link.txt", [](std::ostream& out) { out << "new"; });
  EXPECT_TRUE(fs::is_symlink(folder / "link.txt"));
  EXPECT_EQ(readWholeFile(file), "new");
  EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST(AtomicWrite, ErrorsNameTheFileThatWasAskedFor) {
  const TemporaryFolder folder;
  const auto error = [](const fs::path& file) {
    return errorOf([&] { writeAtomically(file, [](std::ostream& out) { out << "x"; }); });
  };
  const fs::path missing = folder / "none/a.txt";
  EXPECT_EQ(error(missing), missing.string() + ": cannot write: No such file or directory");
  EXPECT_EQ(error(folder.path()), folder.path().string() + ": cannot write: is a folder");
  EXPECT_NE(error("").find("empty"), std::string::npos);
  // A device has no old content to keep and must stay what it is.
  EXPECT_EQ(error("/dev/null"), "");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_NE(error("/dev/full").find("No space left"), std::string::npos);
}

TEST(ReadWholeFile, ErrorsNameFileAndCause) {
  const TemporaryFolder folder;
  const auto error = [](const fs::path& file) { return errorOf([&] { readWholeFile(file); }); };
  EXPECT_EQ(error(folder / "none"), (folder / "none").string() + ": no such file");
  EXPECT_EQ(error(folder.path()), folder.path().string() + ": is a folder, not a file");
  EXPECT_EQ(error(folder.write("e", "")), (folder / "e").string() + ": byte 0: the file is empty");
  EXPECT_EQ(error("/dev/zero"), "/dev/zero: is not a regular file");
}

}  // namespace
}  // namespace hair
