#include <libhair/files/obj_strands.h>

#include <algorithm>

#include <libhair/files/edges.h>
#include <libhair/files/file_units.h>
#include <libhair/files/obj_words.h>
#include <libhair/files/text_writer.h>

namespace hair {

namespace {

struct Lines {
  std::vector<glm::vec3> positions;
  EdgeChains strands;  // a strand a line
  bool onlyEdges = true;
  std::size_t faces = 0;
};

Lines linesOf(TextReader& in, StrandFile& file) {
  Lines lines;
  while (in.nextLine()) {
    const std::string_view whole = in.restOfLine();
    const std::string_view word = objWord(in);
    if (word == "v") {
      lines.positions.push_back(objVertex(in));
    } else if (word == "l" || word == "p") {
      auto& [vertices, first] = lines.strands;
      for (auto corner = objWord(in); !corner.empty() && !corner.starts_with('#');
           corner = objWord(in)) {
        vertices.push_back(objCorner(in, corner, lines.positions.size(), "line"));
        // `p 1 2` is two points.
        if (word == "p") first.push_back(static_cast<std::uint32_t>(vertices.size()));
      }
      if (word == "p") continue;
      const std::size_t count = vertices.size() - first.back();
      in.expect(count >= 2, "line: ", count, " corners, needs at least 2");
      lines.onlyEdges = lines.onlyEdges && count == 2;
      first.push_back(static_cast<std::uint32_t>(vertices.size()));
    } else if (word == "f") {
      ++lines.faces;
    } else if (word == "#") {
      unitsFromText(whole.substr(1 + whole.substr(1).find_first_not_of(' ')), file.scale, file.up);
    }
  }
  return lines;
}

// The lines of two corners as edges, those of one as points.
EdgeChains chained(const Lines& lines, std::string_view name) {
  const auto& [vertices, first] = lines.strands;
  std::vector<std::array<std::uint32_t, 2>> edges;
  std::vector<bool> points(lines.positions.size());
  for (std::size_t s = 0; s + 1 < first.size(); ++s) {
    if (first[s + 1] - first[s] == 2)
      edges.push_back({vertices[first[s]], vertices[first[s] + 1]});
    else
      points[vertices[first[s]]] = true;
  }
  return chainEdges(edges, lines.positions.size(), points, name);
}

}  // namespace

StrandFile parseObjStrands(std::string_view bytes, std::string_view name) {
  StrandFile file;
  file.format = "obj";
  TextReader in(bytes, name);
  Lines lines = linesOf(in, file);
  in.expect(!lines.strands.vertices.empty(), "the file ends without any line of points ('l')",
            lines.faces > 0 ? ": it holds a mesh, not strands" : "");
  if (lines.onlyEdges) lines.strands = chained(lines, name);
  file.strands.points.reserve(lines.strands.vertices.size());
  for (std::uint32_t v : lines.strands.vertices) file.strands.points.push_back(lines.positions[v]);
  file.strands.first = std::move(lines.strands.first);
  if (lines.faces > 0)
    file.notes.push_back(text("lines are the strands; ", lines.faces,
                              " faces besides are a mesh, such as the head (--head)"));
  return file;
}

ObjContents objContents(std::string_view bytes, std::string_view name) {
  TextReader in(bytes, name);
  ObjContents contents;
  while (in.nextLine()) {
    const std::string_view word = in.word();
    contents.lines += word == "l" || word == "p";
    contents.faces += word == "f";
  }
  return contents;
}

void writeObjStrands(std::ostream& stream, const StrandFile& file) {
  const StrandSet& strands = file.strands;
  for (std::size_t i = 0; i < strands.pointCount(); ++i)
    for (int c = 0; c < 3; ++c)
      require(std::abs(strands.points[i][c]) < kObjFarthest, "writing .obj: point ", i, ": ",
              strands.points[i][c], " is beyond 1e8; write it in larger units");
  TextWriter out(stream);
  out << "# " << unitsText(file.scale, file.up) << '\n';
  for (std::size_t s = 0; s < strands.strandCount(); ++s) {
    for (const glm::vec3& p : strands.strand(s))
      out << "v " << p.x << ' ' << p.y << ' ' << p.z << '\n';
    const std::uint32_t begin = strands.first[s], end = strands.first[s + 1];
    if (end - begin == 1) out << "p " << end << '\n';
    // Segment by segment: of a longer line Blender 3.4 takes the first two corners.
    for (std::uint32_t v = begin + 1; v < end; ++v) out << "l " << v << ' ' << v + 1 << '\n';
  }
}

}  // namespace hair
