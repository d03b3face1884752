// Makes small glTF and OBJ files for tests of the import.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "appliance/authoring/model/accessor.h"
#include "appliance/authoring/model/model.h"

namespace kaori::model {

// Collects buffer views, accessors and the rest of a document as JSON text.
class GlbMaker {
 public:
  // Adds bytes; returns the number of their view. `stride_bytes` 0: tight.
  int AddView(const std::vector<std::uint8_t>& bytes, int stride_bytes = 0);
  // `extra` is put into the accessor as it is: "\"normalized\":true".
  int AddAccessor(int view, Component component, std::size_t count, const std::string& type,
                  const std::string& extra = "");

  int AddVec3(const std::vector<glm::vec3>& values);
  int AddVec2(const std::vector<glm::vec2>& values);
  int AddIndices(const std::vector<Triangle>& triangles);

  // Both as JSON: {"primitives":[...]}, {"mesh":0}.
  void AddMesh(std::string json) { meshes_.push_back(std::move(json)); }
  void AddNode(std::string json) { nodes_.push_back(std::move(json)); }
  // Put into the document as it is: "\"extensions\":{...}".
  void AddToDocument(std::string json) { extra_ += "," + std::move(json); }

  // A mesh with its targets, and a node for it. In v of glTF, which runs down.
  void AddModel(const Model& model, const std::string& name);

  std::vector<std::uint8_t> Glb() const;

 private:
  std::string Json() const;

  std::vector<std::uint8_t> buffer_;
  std::vector<std::string> views_, accessors_, meshes_, nodes_;
  std::string extra_;
};

template <class T>
std::vector<std::uint8_t> BytesOf(const std::vector<T>& values) {
  const auto* first = reinterpret_cast<const std::uint8_t*>(values.data());
  return {first, first + values.size() * sizeof(T)};
}

// A square plate in the plane z = 0, `cells` by `cells`, 0.1 m wide, with texture coordinates; its middle row
// of edges is slit open from the left border to the middle when `slit` is set.
Model Plate(int cells, bool slit);

std::string ObjText(const Model& model);

}  // namespace kaori::model
