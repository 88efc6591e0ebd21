#include "flow_file.h"

#include <bit>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace arris {
namespace {

static_assert(std::endian::native == std::endian::little, "the arrays are written as they are");
constexpr char magic[9] = "ARRISFG1";

template <class T>
void write_array(std::ofstream& file, const std::vector<T>& values) {
  file.write(reinterpret_cast<const char*>(values.data()),
             static_cast<std::streamsize>(values.size() * sizeof(T)));
}

template <class T>
void read_array(std::ifstream& file, std::vector<T>& values, std::uint64_t n) {
  values.resize(n);
  file.read(reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(n * sizeof(T)));
}

}  // namespace

void dump_flow_graph(const std::string& path, const FlowGraph& graph) {
  std::ofstream file(path, std::ios::binary);
  const std::uint64_t n = graph.terminal.size();
  file.write(magic, 8);
  file.write(reinterpret_cast<const char*>(&n), sizeof n);
  write_array(file, graph.neighbours);
  write_array(file, graph.capacity);
  write_array(file, graph.terminal);
  if (!file.flush()) throw std::runtime_error("cannot write " + path);
}

FlowGraph load_flow_graph(const std::string& path) {
  constexpr std::uint64_t header_bytes = 16, node_bytes = 40;
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  const auto bytes = static_cast<std::uint64_t>(file.tellg());
  file.seekg(0);
  char start[8] = {};
  std::uint64_t n = 0;
  file.read(start, 8);
  file.read(reinterpret_cast<char*>(&n), sizeof n);
  if (!file || std::memcmp(start, magic, 8) != 0 || n != (bytes - header_bytes) / node_bytes)
    throw std::runtime_error(path + " is not a flow graph");
  FlowGraph graph;
  read_array(file, graph.neighbours, n);
  read_array(file, graph.capacity, n);
  read_array(file, graph.terminal, n);
  if (!file) throw std::runtime_error(path + " ends too early");
  return graph;
}

}  // namespace arris
