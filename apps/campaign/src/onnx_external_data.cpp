// SPDX-License-Identifier: BSD-3-Clause
#include "onnx_external_data.h"

#include <cstdint>
#include <optional>
#include <string_view>

namespace slalom {
namespace {

enum class Message {
  Model,
  Graph,
  Node,
  Attribute,
  Tensor,
  SparseTensor,
  Function,
  Training,
  Entry
};

/// Fields of onnx.proto that lead to tensors.
struct TensorField {
  Message in;
  std::uint64_t number;
  Message content;
};
constexpr TensorField kTensorFields[] = {{Message::Model, 7, Message::Graph},
                                         {Message::Model, 20, Message::Training},
                                         {Message::Model, 25, Message::Function},
                                         {Message::Training, 1, Message::Graph},
                                         {Message::Training, 2, Message::Graph},
                                         {Message::Graph, 1, Message::Node},
                                         {Message::Graph, 5, Message::Tensor},
                                         {Message::Graph, 15, Message::SparseTensor},
                                         {Message::Function, 7, Message::Node},
                                         {Message::Function, 11, Message::Attribute},
                                         {Message::Node, 5, Message::Attribute},
                                         {Message::Attribute, 5, Message::Tensor},
                                         {Message::Attribute, 6, Message::Graph},
                                         {Message::Attribute, 10, Message::Tensor},
                                         {Message::Attribute, 11, Message::Graph},
                                         {Message::Attribute, 22, Message::SparseTensor},
                                         {Message::Attribute, 23, Message::SparseTensor},
                                         {Message::SparseTensor, 1, Message::Tensor},
                                         {Message::SparseTensor, 2, Message::Tensor},
                                         {Message::Tensor, 13, Message::Entry}};

/// Graphs in attributes of nodes contain others.
constexpr int kMaxDepth = 64;

/// Takes a number from the beginning of the bytes; none if they end before it does.
std::optional<std::uint64_t> take_number(std::string_view& bytes) {
  std::uint64_t number = 0;
  for (int shift = 0; shift < 64 && !bytes.empty(); shift += 7) {
    const auto byte = static_cast<unsigned char>(bytes.front());
    bytes.remove_prefix(1);
    number |= std::uint64_t{byte & 0x7FU} << shift;
    if (byte < 0x80) return number;
  }
  return std::nullopt;
}

/// Takes the content of a field of this wire type; none if the bytes are not of that type.
std::optional<std::string_view> take_content(std::string_view& bytes, std::uint64_t type) {
  std::optional<std::uint64_t> size;
  if (type == 0) {
    if (!take_number(bytes)) return std::nullopt;
    size = 0;
  } else {
    size = type == 1   ? std::optional<std::uint64_t>(8)
           : type == 2 ? take_number(bytes)
           : type == 5 ? std::optional<std::uint64_t>(4)
                       : std::nullopt;
  }
  if (!size || *size > bytes.size()) return std::nullopt;
  const std::string_view content = bytes.substr(0, static_cast<std::size_t>(*size));
  bytes.remove_prefix(content.size());
  return content;
}

void find_locations(std::string_view bytes, Message message, int depth,
                    std::vector<std::string>& locations) {
  std::string_view key, value;
  while (!bytes.empty()) {
    const auto tag = take_number(bytes);
    const auto content = tag ? take_content(bytes, *tag % 8) : std::nullopt;
    if (!content) return;
    const std::uint64_t number = *tag / 8;
    if (message == Message::Entry) (number == 1 ? key : value) = *content;
    for (const TensorField& field : kTensorFields)
      if (field.in == message && field.number == number && *tag % 8 == 2 && depth < kMaxDepth)
        find_locations(*content, field.content, depth + 1, locations);
  }
  if (message == Message::Entry && key == "location") locations.emplace_back(value);
}

}  // namespace

std::vector<std::string> onnx_external_data(const std::string& model) {
  std::vector<std::string> locations;
  find_locations(model, Message::Model, 0, locations);
  return locations;
}

}  // namespace slalom
