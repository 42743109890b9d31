#include <libhair/files/obj.h>

#include <algorithm>

#include <libhair/files/byte_reader.h>
#include <libhair/files/file_units.h>
#include <libhair/files/obj_words.h>
#include <libhair/geometry/openmesh-inl.h>

namespace hair {

namespace {

using Mesh = OpenPolyMesh;
using Corners = std::vector<Mesh::VertexHandle>;

// A corner that follows itself makes an edge of no length, which tells nothing.
void removeRepeats(Corners& corners) {
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  while (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
}

// Adds a face that no edge of the mesh can take, on vertices of its own.
void addSplit(Mesh& mesh, Corners& corners) {
  for (Mesh::VertexHandle& v : corners) {
    const Mesh::Point p = mesh.point(v);  // by value: add_vertex moves the points
    v = mesh.add_vertex(p);
  }
  mesh.add_face(corners);
}

Mesh parse(TextReader& in, ObjReport& report) {
  Mesh mesh;
  std::vector<Corners> later;
  Corners corners;
  while (in.nextLine()) {
    const std::string_view whole = in.restOfLine();
    const std::string_view word = in.word();
    if (word == "#") {
      unitsFromText(whole.substr(1 + whole.substr(1).find_first_not_of(' ')), report.scale,
                    report.up);
    } else if (word == "v") {
      const glm::vec3 p = objVertex(in);
      mesh.add_vertex(Mesh::Point(p.x, p.y, p.z));
    } else if (word == "f") {
      ++report.faces;
      corners.clear();
      for (auto corner = objWord(in); !corner.empty(); corner = objWord(in))
        corners.emplace_back(static_cast<int>(objCorner(in, corner, mesh.n_vertices())));
      expectObjFace(in, corners.size());
      removeRepeats(corners);
      if (corners.size() < 3)
        ++report.dropped;
      else
        later.push_back(corners);
    }
  }
  // Faces last: so vertices of split faces come after all of the file's own.
  for (Corners& face : later) {
    Corners sorted = face;
    std::sort(sorted.begin(), sorted.end());
    const bool simple = std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
    if (simple && mesh.add_face(face).is_valid()) continue;
    ++report.split;
    addSplit(mesh, face);
  }
  return mesh;
}

}  // namespace

TriangleMesh parseObj(std::string_view bytes, std::string_view name, ObjReport* report) {
  const SilentOpenMesh silent;
  TextReader in(bytes, name);
  ObjReport own;
  ObjReport& r = report ? *report : own;
  r = {};
  Mesh mesh = parse(in, r);
  in.expect(mesh.n_vertices() > 0, "the file ends without any vertex: this is no OBJ file");
  in.expect(mesh.n_faces() > 0, "the file ends without any face");
  mesh.triangulate();

  TriangleMesh out;
  out.positions.reserve(mesh.n_vertices());
  for (const Mesh::VertexHandle v : mesh.vertices()) {
    const Mesh::Point& p = mesh.point(v);
    out.positions.emplace_back(p[0], p[1], p[2]);
  }
  out.triangles.reserve(mesh.n_faces());
  for (const Mesh::FaceHandle f : mesh.faces()) {
    glm::uvec3 triangle;
    int k = 0;
    for (auto v = mesh.cfv_ccwbegin(f); v.is_valid() && k < 3; ++v, ++k)
      triangle[k] = static_cast<std::uint32_t>(v->idx());
    out.triangles.push_back(triangle);
  }
  computeNormals(out);
  return out;
}

TriangleMesh readObj(const std::filesystem::path& file, ObjReport* report) {
  return parseObj(readWholeFile(file), file.string(), report);
}

TriangleMesh readObj(const std::filesystem::path& file, const ReadOptions& options,
                     ObjReport* report) {
  ObjReport own;
  ObjReport& r = report ? *report : own;
  TriangleMesh mesh = readObj(file, &r);
  if (options.scale > 0 || r.scale == 0) r.scale = options.scale > 0 ? options.scale : 1;
  if (options.up != UpAxis::AsFile || r.up == UpAxis::AsFile)
    r.up = options.up == UpAxis::AsFile ? UpAxis::Y : options.up;
  convertUnits(mesh.positions, r.scale, r.up);
  convertUnits(mesh.normals, 1, r.up);
  return mesh;
}

}  // namespace hair
