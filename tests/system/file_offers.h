// What somebody may put where a program wants a file: none of it is one.
#pragma once

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace kaori::test {

// Puts something at `file` that a program should refuse, or should be able to bear.
struct Offer {
  std::string name;
  std::function<void(const std::filesystem::path& file)> put;
  friend void PrintTo(const Offer& offer, std::ostream* out) { *out << offer.name; }
};

inline void Fill(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

inline std::string Repeated(std::string_view part, int times) {
  std::string text;
  for (int i = 0; i < times; ++i) text += part;
  return text;
}

inline std::string Noise() {
  std::string bytes(100'000, '\0');
  std::uint32_t state = 1;
  for (char& byte : bytes) byte = static_cast<char>((state = state * 1664525U + 1013904223U) >> 24U);
  return bytes;
}

inline const std::vector<Offer>& Offers() {
  constexpr int kDeep = 200'000;
  static const std::vector<Offer> offers{
      {"missing", [](const std::filesystem::path&) {}},
      {"folder", [](const std::filesystem::path& file) { std::filesystem::create_directory(file); }},
      {"zeroes",
       [](const std::filesystem::path& file) { std::filesystem::create_symlink("/dev/zero", file); }},
      {"sparse",
       [](const std::filesystem::path& file) {
         Fill(file, "");
         std::filesystem::resize_file(file, std::uintmax_t{1} << 30U);
       }},
      {"pipe", [](const std::filesystem::path& file) { ASSERT_EQ(::mkfifo(file.c_str(), 0600), 0); }},
      {"deep_tables",
       [](const std::filesystem::path& file) { Fill(file, "[a" + Repeated(".a", kDeep) + "]\nb = 1\n"); }},
      {"deep_keys",
       [](const std::filesystem::path& file) { Fill(file, "a" + Repeated(".a", kDeep) + " = 1\n"); }},
      {"deep_lists", [](const std::filesystem::path& file) { Fill(file, "a = " + Repeated("[", kDeep)); }},
      {"deep_json", [](const std::filesystem::path& file) { Fill(file, Repeated("{\"keys\":[", kDeep)); }},
      {"noise", [](const std::filesystem::path& file) { Fill(file, Noise()); }},
      {"empty", [](const std::filesystem::path& file) { Fill(file, ""); }},
  };
  return offers;
}

}  // namespace kaori::test
