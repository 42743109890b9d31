#include <libhair/hair_mesh/hair_mesh_file.h>

#include <algorithm>
#include <charconv>
#include <numeric>
#include <ostream>

#include <libhair/files/atomic_write.h>
#include <libhair/files/byte_reader.h>
#include <libhair/files/obj_words.h>

namespace hair {

namespace {

struct Object {
  std::string name;
  std::vector<std::uint32_t> firstCorner = {0};  // [faceCount + 1]
  std::vector<std::uint32_t> corners;            // vertices of the file, from 0
  std::vector<std::size_t> lines;                // [faceCount]

  std::size_t faceCount() const { return lines.size(); }
  std::uint32_t sides(std::size_t f) const { return firstCorner[f + 1] - firstCorner[f]; }
};

struct ObjectFile {
  std::vector<glm::vec3> positions;
  std::vector<Object> objects;  // those with faces
};

// An object begins at each line of `word` ("" : the file is one object).
ObjectFile parseObjects(std::string_view bytes, std::string_view name, std::string_view word) {
  TextReader in(bytes, name);
  ObjectFile file;
  Object object;
  const auto finish = [&] {
    if (object.faceCount() > 0) file.objects.push_back(std::move(object));
    object = {};
  };
  while (in.nextLine()) {
    const std::string_view first = in.word();
    if (first == "v") {
      file.positions.push_back(objVertex(in));
    } else if (first == "f") {
      const std::size_t before = object.corners.size();
      while (!in.lineDone())
        object.corners.push_back(objCorner(in, in.word(), file.positions.size()));
      expectObjFace(in, object.corners.size() - before);
      in.expect(object.corners.size() < kNoVertex, "face: too many for a hair mesh");
      object.firstCorner.push_back(static_cast<std::uint32_t>(object.corners.size()));
      object.lines.push_back(in.lineNumber());
    } else if (!word.empty() && first == word) {
      finish();
      object.name = in.restOfLine();
    }
  }
  finish();
  in.expect(!file.positions.empty(), "the file ends without any vertex: this is no OBJ file");
  in.expect(!file.objects.empty(), "the file ends without any face");
  return file;
}

bool hasLine(std::string_view bytes, std::string_view word) {
  TextReader in(bytes, {});
  while (in.nextLine())
    if (in.word() == word) return true;
  return false;
}

// N of "layer_N", "layer_N.001", "layer_N_Mesh"; -1: another name.
long long layerNumber(std::string_view name) {
  constexpr std::string_view kLayer = "layer_";
  if (!name.starts_with(kLayer)) return -1;
  name.remove_prefix(kLayer.size());
  std::uint32_t number = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  return error == std::errc() ? number : -1;
}

void orderByName(std::vector<Object>& objects, std::string_view file) {
  const auto number = [](const Object& o) { return layerNumber(o.name); };
  if (std::any_of(objects.begin(), objects.end(), [&](auto& o) { return number(o) < 0; })) return;
  std::stable_sort(objects.begin(), objects.end(),
                   [&](auto& a, auto& b) { return number(a) < number(b); });
  for (std::size_t k = 1; k < objects.size(); ++k)
    require(number(objects[k]) > number(objects[k - 1]), file, ": line ", objects[k].lines.front(),
            ": two objects are layer ", number(objects[k]), ": ",
            TextReader::shown(objects[k - 1].name), " and ", TextReader::shown(objects[k].name));
}

// Numbers of the vertices in the layer that uses them, in the order of the file.
class LayerVertices {
 public:
  LayerVertices(const ObjectFile& file, std::string_view name)
      : layer_(file.positions.size(), kNoVertex), local_(file.positions.size()) {
    std::vector<std::uint32_t> count(file.objects.size(), 0);
    for (std::size_t k = 0; k < file.objects.size(); ++k) claim(file.objects, k, name);
    for (std::size_t v = 0; v < layer_.size(); ++v)
      if (layer_[v] != kNoVertex) local_[v] = count[layer_[v]]++;
  }

  std::uint32_t layer(std::size_t v) const { return layer_[v]; }
  std::uint32_t local(std::size_t v) const { return local_[v]; }

 private:
  void claim(const std::vector<Object>& objects, std::size_t k, std::string_view name) {
    const Object& object = objects[k];
    for (std::size_t f = 0; f < object.faceCount(); ++f)
      for (std::uint32_t c = object.firstCorner[f]; c < object.firstCorner[f + 1]; ++c) {
        std::uint32_t& owner = layer_[object.corners[c]];
        if (owner == kNoVertex) owner = static_cast<std::uint32_t>(k);
        require(owner == k, name, ": line ", object.lines[f], ": face: vertex ",
                object.corners[c] + 1, " is one of another layer, ",
                TextReader::shown(objects[owner].name));
      }
  }

  std::vector<std::uint32_t> layer_, local_;
};

// Each layer of a mesh has an array of all corners, used or not: a small file of thousands of
// layers of one face, on a scalp of thousands of faces, would need very much memory.
void requireProportion(const ObjectFile& file, std::size_t bytes, std::string_view name) {
  const std::size_t corners = file.objects.front().corners.size();
  const std::size_t most = (std::size_t{1} << 20) / 8 + 32 * bytes;
  require(file.objects.size() <= most / corners, name, ": ", file.objects.size(), " layers on ",
          corners, " corners of roots, most of them empty; a file of ", bytes,
          " bytes may have layers times corners up to ", most);
}

// Sets the corners of layer k, and the vertices below its own; lower layers must be complete.
void fillLayer(const ObjectFile& file, std::size_t k, const LayerVertices& vertices,
               std::string_view name, HairMesh& mesh) {
  const Object& object = file.objects[k];
  const Object& root = file.objects.front();
  HairMesh::Layer& layer = mesh.layers[k];
  layer.pinned.assign(layer.vertexCount(), 0);
  if (k > 0) layer.below.assign(layer.vertexCount(), kNoVertex);
  layer.corners.reserve(root.corners.size());
  for (std::size_t f = 0; f < object.faceCount(); ++f) {
    const auto fail = [&](const auto&... parts) {
      throw Error(text(name, ": line ", object.lines[f], ": ", TextReader::shown(object.name), ": ",
                       parts...));
    };
    if (k > 0 && f >= file.objects[k - 1].faceCount())
      fail("more faces than the layer below has (", file.objects[k - 1].faceCount(), ")");
    if (object.sides(f) != root.sides(f))
      fail("face ", f + 1, " of the object has ", object.sides(f), " corners, its root (line ",
           root.lines[f], ") has ", root.sides(f));
    for (std::uint32_t c = object.firstCorner[f]; c < object.firstCorner[f + 1]; ++c) {
      const std::uint32_t v = vertices.local(object.corners[c]);
      layer.corners.push_back(v);
      if (k == 0) continue;
      const std::uint32_t on = mesh.layers[k - 1].corners[c];
      if (layer.below[v] == kNoVertex) layer.below[v] = on;
      if (layer.below[v] != on)
        fail("vertex ", object.corners[c] + 1, " stands on two vertices of the layer below");
    }
  }
  layer.corners.resize(root.corners.size(), kNoVertex);
}

void putNumber(std::string& bytes, float value) {
  char digits[32];
  // Nine digits reproduce every float; fewer that do are not safe for readers that parse doubles.
  const auto end =
      std::to_chars(digits, digits + sizeof digits, value, std::chars_format::general, 9).ptr;
  (bytes += ' ').append(digits, end);
}

}  // namespace

HairMesh parseHairMesh(std::string_view bytes, std::string_view name) {
  const std::string_view word = hasLine(bytes, "o") ? "o" : "g";
  ObjectFile file = parseObjects(bytes, name, word);
  require(word == "o" || hasLine(bytes, "g"), name,
          ": no object: a hair mesh has one (o layer_0, o layer_1 ...) for each layer");
  orderByName(file.objects, name);
  requireProportion(file, bytes.size(), name);
  const LayerVertices vertices(file, name);

  HairMesh mesh;
  const Object& root = file.objects.front();
  mesh.firstCorner = root.firstCorner;
  mesh.lastLayer.resize(root.faceCount());
  mesh.layers.resize(file.objects.size());
  for (std::size_t v = 0; v < file.positions.size(); ++v)
    if (vertices.layer(v) != kNoVertex)
      mesh.layers[vertices.layer(v)].positions.push_back(file.positions[v]);
  for (std::size_t k = 0; k < file.objects.size(); ++k) {
    fillLayer(file, k, vertices, name, mesh);
    for (std::size_t f = 0; f < file.objects[k].faceCount(); ++f)
      mesh.lastLayer[f] = static_cast<std::uint32_t>(k);
  }
  validate(mesh, name);
  return mesh;
}

HairMesh readHairMesh(const std::filesystem::path& file) {
  return parseHairMesh(readWholeFile(file), file.string());
}

PolygonMesh parsePolygons(std::string_view bytes, std::string_view name) {
  ObjectFile file = parseObjects(bytes, name, "");
  Object& faces = file.objects.front();
  return {std::move(file.positions), std::move(faces.firstCorner), std::move(faces.corners)};
}

std::vector<std::uint32_t> fileOrder(const HairMesh& mesh) {
  std::vector<std::uint32_t> order(mesh.bundleCount());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return mesh.lastLayer[a] > mesh.lastLayer[b];
  });
  return order;
}

std::string hairMeshBytes(const HairMesh& mesh) {
  validate(mesh);
  const std::vector<std::uint32_t> order = fileOrder(mesh);
  std::string bytes =
      "# libhair hair mesh: an object a layer, root first; metres, +Y up, +Z face.\n"
      "# Face i, corner j of a layer stands on face i, corner j of the layer before.\n";
  std::size_t firstVertex = 1;
  for (std::size_t k = 0; k < mesh.layerCount(); ++k) {
    const HairMesh::Layer& layer = mesh.layers[k];
    bytes += text("o layer_", k, '\n');
    for (const glm::vec3 p : layer.positions) {
      bytes += 'v';
      for (int c = 0; c < 3; ++c) {
        require(std::abs(p[c]) < kObjFarthest, "hair mesh: layer ", k, ": ", p[c],
                " is beyond 1e8 (check the scale)");
        putNumber(bytes, p[c]);
      }
      bytes += '\n';
    }
    for (const std::uint32_t j : order) {
      if (mesh.lastLayer[j] < k) break;
      bytes += 'f';
      for (const std::uint32_t v : mesh.face(k, j))
        (bytes += ' ') += std::to_string(firstVertex + v);
      bytes += '\n';
    }
    firstVertex += layer.vertexCount();
  }
  return bytes;
}

std::vector<std::uint32_t> writeHairMesh(const std::filesystem::path& file, const HairMesh& mesh) {
  const std::string bytes = hairMeshBytes(mesh);
  writeAtomically(file, [&](std::ostream& out) { out << bytes; });
  return fileOrder(mesh);
}

}  // namespace hair
