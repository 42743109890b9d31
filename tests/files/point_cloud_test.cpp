// Strands as clouds of points, and as lists of vertices: PLY files as other programs write them.
#include <algorithm>
#include <array>
#include <sstream>

#include <gtest/gtest.h>

#include <libhair/files/ply_file.h>
#include <libhair/files/point_cloud.h>

#include "grooms.h"
#include "samples.h"

namespace hair {
namespace {

// A number in some byte order.
template <class T>
void put(std::string& bytes, T value, bool big) {
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), &value, sizeof(T));
  if (big) std::reverse(raw.begin(), raw.end());
  bytes.append(raw.data(), raw.size());
}

enum class Kind { Text, Little, Big };

// Values of a row are floats, and then whole numbers behind a count where there is a list.
class PlyWriter {
 public:
  explicit PlyWriter(Kind kind) : kind_(kind) {
    head_ = text("ply\nformat ",
                 kind == Kind::Text  ? "ascii"
                 : kind == Kind::Big ? "binary_big_endian"
                                     : "binary_little_endian",
                 " 1.0\n");
  }
  void header(const std::string& lines) { head_ += lines; }
  void number(float value) { add(value); }
  void integer(std::int32_t value) { add(value); }
  void count(std::uint8_t value) {
    if (kind_ == Kind::Text)
      body_ += text(int{value}, ' ');
    else
      put(body_, value, false);
  }
  void end() {
    if (kind_ == Kind::Text) body_ += '\n';
  }
  std::string bytes() const { return head_ + "end_header\n" + body_; }

 private:
  template <class T>
  void add(T value) {
    if (kind_ == Kind::Text) {
      std::ostringstream out;
      out.precision(9);
      out << value << ' ';
      body_ += out.str();
    } else {
      put(body_, value, kind_ == Kind::Big);
    }
  }

  Kind kind_;
  std::string head_, body_;
};

void addVertices(PlyWriter& ply, const StrandSet& strands, bool ids = false) {
  ply.header(text("element vertex ", strands.pointCount(),
                  "\nproperty float x\nproperty float y\nproperty float z\n",
                  ids ? "property int strand_id\n" : ""));
  for (std::size_t s = 0; s < strands.strandCount(); ++s)
    for (const glm::vec3 p : strands.strand(s)) {
      for (int c = 0; c < 3; ++c) ply.number(p[c]);
      if (ids) ply.integer(static_cast<std::int32_t>(7 * s));
      ply.end();
    }
}

void expectSame(const StrandFile& file, const StrandSet& strands, const std::string& of) {
  SCOPED_TRACE(of);
  EXPECT_EQ(file.strands.first, strands.first);
  EXPECT_EQ(file.strands.points, strands.points);
}

TEST(PointCloud, ShowsHowManyPointsAStrandHas) {
  for (const std::uint32_t points : {5u, 12u, 25u, 64u})
    for (const bool curly : {false, true}) {
      const StrandSet strands = sampleGroom({.strands = 90, .points = points, .curly = curly});
      EXPECT_EQ(pointsPerStrandOf(strands.points), points) << (curly ? "curly" : "straight");
    }
  // Of one point a step everywhere nothing is seen.
  std::vector<glm::vec3> line;
  for (int i = 0; i < 60; ++i) line.emplace_back(0, 0.1f * static_cast<float>(i), 0);
  EXPECT_EQ(pointsPerStrandOf(line), 0u);
}

TEST(PointCloud, IsReadAsStrandsAndSaysSo) {
  const StrandSet strands = sampleGroom({.strands = 60, .points = 12});
  for (const Kind kind : {Kind::Text, Kind::Little, Kind::Big}) {
    PlyWriter ply(kind);
    addVertices(ply, strands);
    const StrandFile guessed = parsePly(ply.bytes(), "a.ply");
    expectSame(guessed, strands, "guessed");
    ASSERT_EQ(guessed.notes.size(), 1u);
    EXPECT_NE(guessed.notes[0].find("12 points a strand"), std::string::npos);
    const StrandFile asked = parsePly(ply.bytes(), "a.ply", 6);
    EXPECT_EQ(asked.strands.strandCount(), 120u);
    EXPECT_TRUE(asked.notes.empty());
    EXPECT_NE(errorOf([&] {
                parsePly(ply.bytes(), "a.ply", 7);
              }).find("720 points are no strands of 7 points each (--points-per-strand)"),
              std::string::npos);
  }
}

TEST(PointCloud, StrandsThatAreNumberedHaveAnyLength) {
  const StrandSet strands = sampleGroom({.strands = 40, .points = 9, .uneven = true});
  for (const Kind kind : {Kind::Text, Kind::Little, Kind::Big}) {
    PlyWriter ply(kind);
    addVertices(ply, strands, true);
    expectSame(parsePly(ply.bytes(), "a.ply"), strands, "strand_id");
  }
}

TEST(PlyLines, OfEveryKindAndByteOrder) {
  const StrandSet strands = sampleGroom({.strands = 40, .points = 9, .uneven = true});
  for (const Kind kind : {Kind::Text, Kind::Little, Kind::Big}) {
    for (const char* ends : {"vertex1 vertex2", "v1 v2", "v0 v1", "start end"}) {
      PlyWriter ply(kind);
      addVertices(ply, strands);
      const std::string a(ends, 0, std::string(ends).find(' ')), b(ends + a.size() + 1);
      ply.header(text("element edge ", strands.segmentCount(), "\nproperty int ", a,
                      "\nproperty int ", b, '\n'));
      for (std::size_t s = 0; s < strands.strandCount(); ++s)
        for (std::uint32_t i = strands.first[s]; i + 1 < strands.first[s + 1]; ++i) {
          ply.integer(static_cast<std::int32_t>(i));
          ply.integer(static_cast<std::int32_t>(i + 1));
          ply.end();
        }
      expectSame(parsePly(ply.bytes(), "a.ply"), strands, ends);
    }
    for (const char* name : {"polyline", "line", "strand", "curves"}) {
      PlyWriter lists(kind), pairs(kind);
      addVertices(lists, strands);
      addVertices(pairs, strands);
      lists.header(text("element ", name, ' ', strands.strandCount(),
                        "\nproperty list uchar int vertex_indices\n"));
      pairs.header(text("element ", name, ' ', strands.segmentCount(),
                        "\nproperty list uchar int vertex_index\n"));
      for (std::size_t s = 0; s < strands.strandCount(); ++s) {
        const std::uint32_t begin = strands.first[s], end = strands.first[s + 1];
        lists.count(static_cast<std::uint8_t>(end - begin));
        for (std::uint32_t i = begin; i < end; ++i) lists.integer(static_cast<std::int32_t>(i));
        lists.end();
        for (std::uint32_t i = begin; i + 1 < end; ++i) {
          pairs.count(2);
          pairs.integer(static_cast<std::int32_t>(i));
          pairs.integer(static_cast<std::int32_t>(i + 1));
          pairs.end();
        }
      }
      expectSame(parsePly(lists.bytes(), "a.ply"), strands, name);
      expectSame(parsePly(pairs.bytes(), "a.ply"), strands, text(name, " of two"));
    }
  }
}

TEST(PlyLines, DamageIsAnError) {
  const auto error = [](const std::string& more) {
    return errorOf([&] {
      parsePly(
          "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
          "property float z\nelement line 1\nproperty list uchar int v\nend_header\n0 0 0\n"
          "0 1 0\n" +
              more,
          "a.ply");
    });
  };
  EXPECT_EQ(error("2 0 1\n"), "");
  EXPECT_NE(error("2 0 2\n").find("line 0: vertex 2 does not exist"), std::string::npos);
  EXPECT_NE(error("3 0 1\n").find("a number is missing"), std::string::npos);
  EXPECT_NE(error("2 0 -1\n").find("vertex -1 does not exist"), std::string::npos);
}

}  // namespace
}  // namespace hair
