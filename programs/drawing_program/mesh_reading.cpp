// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_reading.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <future>
#include <string_view>

#include "mesh_files/mesh_file.h"

namespace fs = std::filesystem;
using line_drawing::Words;

namespace {

[[noreturn]] void refuse(const std::string& file, const std::string& why) {
    laplacian_lines::refuse(file + ": " + why, laplacian_lines::ErrorCode::InvalidMesh);
}

std::optional<mesh_files::Format> format_of(const fs::path& file) {
    const std::string ending = line_drawing::lower(file.extension().u8string());
    return mesh_files::format_of(ending.substr(std::min<std::size_t>(1, ending.size())));
}

Words meshes_in(const std::string& folder) {
    Words meshes;
    std::error_code error;
    for (fs::directory_iterator entry(fs::u8path(folder), error), end; !error && entry != end;
         entry.increment(error))
        if (std::error_code none; format_of(entry->path()) && entry->is_regular_file(none))
            meshes.push_back(entry->path().u8string());
    std::sort(meshes.begin(), meshes.end());
    return meshes;
}

using State = std::array<std::uint32_t, 8>;

constexpr std::size_t kBlock = 64;

// Of FIPS 180-4: first 32 bits of the fractions of square and cube roots of the first primes.
constexpr State kFirstState = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                               0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
constexpr std::array<std::uint32_t, 64> kRoundConstants = {
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};

std::uint32_t turned(std::uint32_t x, int bits) {
    return x >> bits | x << (32 - bits);
}

void add_block(State& state, const unsigned char* bytes) {
    std::array<std::uint32_t, kRoundConstants.size()> w;
    for (std::size_t i = 0; i < 16; ++i, bytes += 4)
        w[i] = std::uint32_t(bytes[0]) << 24 | bytes[1] << 16 | bytes[2] << 8 | bytes[3];
    for (std::size_t i = 16; i < w.size(); ++i) {
        const std::uint32_t a = w[i - 15], b = w[i - 2];
        w[i] = w[i - 16] + (turned(a, 7) ^ turned(a, 18) ^ a >> 3) + w[i - 7] +
               (turned(b, 17) ^ turned(b, 19) ^ b >> 10);
    }
    auto [a, b, c, d, e, f, g, h] = state;
    for (std::size_t i = 0; i < w.size(); ++i) {
        const std::uint32_t chosen = (e & f) ^ (~e & g), most = (a & b) ^ (a & c) ^ (b & c);
        const std::uint32_t one =
            h + (turned(e, 6) ^ turned(e, 11) ^ turned(e, 25)) + chosen + kRoundConstants[i] + w[i];
        const std::uint32_t two = (turned(a, 2) ^ turned(a, 13) ^ turned(a, 22)) + most;
        h = g, g = f, f = e, e = d + one, d = c, c = b, b = a, a = one + two;
    }
    const State added = {a, b, c, d, e, f, g, h};
    for (std::size_t i = 0; i < state.size(); ++i)
        state[i] += added[i];
}

/// The SHA-256 of the bytes, in lower hexadecimal.
std::string sha256_of(std::string_view bytes) {
    State state = kFirstState;
    const auto add = [&](std::string_view blocks) {
        for (std::size_t i = 0; i + kBlock <= blocks.size(); i += kBlock)
            add_block(state, reinterpret_cast<const unsigned char*>(blocks.data()) + i);
    };
    add(bytes);
    std::string end(bytes.substr(bytes.size() / kBlock * kBlock));
    end += '\x80';
    end.append((2 * kBlock - 8 - end.size()) % kBlock, '\0');
    for (int shift = 56; shift >= 0; shift -= 8)
        end += char(8 * std::uint64_t(bytes.size()) >> shift);
    add(end);
    std::string digits;
    for (const std::uint32_t word : state)
        for (int shift = 28; shift >= 0; shift -= 4)
            digits += "0123456789abcdef"[word >> shift & 15];
    return digits;
}

}  // namespace

bool is_folder(const std::string& name) {
    std::error_code none;
    return fs::is_directory(fs::u8path(name), none);
}

bool is_named_like_mesh(const std::string& name) {
    return format_of(fs::u8path(name)).has_value();
}

Words meshes_of(const Words& named) {
    Words meshes;
    for (const std::string& name : named) {
        const Words found = is_folder(name) ? meshes_in(name) : Words{name};
        if (found.empty())
            laplacian_lines::refuse("there is no mesh in the folder \"" + name + "\".");
        for (const std::string& mesh : found)
            if (std::find(meshes.begin(), meshes.end(), mesh) == meshes.end())
                meshes.push_back(mesh);
    }
    return meshes;
}

std::optional<std::string> contents_of(const std::string& name) {
    const fs::path file = fs::u8path(name);
    std::error_code error;
    const std::uintmax_t size = fs::file_size(file, error);  // fails for folders and devices
    if (error) return {};
    std::string bytes(size, '\0');
    std::ifstream stream(file, std::ios::binary);
    if (!stream.read(bytes.data(), std::streamsize(size))) return {};
    return bytes;
}

std::string readable(const std::string& name) {
    return line_drawing::in_utf8(line_drawing::letters_of(name));
}

ReadMesh read_mesh(const std::string& file, bool draws_damaged) {
    const std::optional<std::string> bytes = contents_of(file);
    if (!bytes) refuse(file, "there is no such file, or it cannot be read.");
    const fs::path name = fs::u8path(file).filename();
    const auto format = format_of(name);
    if (!format)
        refuse(file,
               "meshes are read from PLY, OBJ, STL and OFF files; MeshLab exports others as "
               "these.");
    auto hash = std::async(std::launch::async, [&] { return sha256_of(*bytes); });
    auto [mesh, defect, remark] = mesh_files::read_mesh(*format, *bytes);
    if (mesh.triangles.empty() && !defect.empty())
        refuse(file, "the mesh cannot be read: " + defect + '.');
    if (mesh.triangles.empty())
        refuse(file,
               "the mesh has no faces; lines are drawn on surfaces. If it is a point cloud, "
               "reconstruct one first." +
                   (remark.empty() ? "" : " Of the file, " + remark + '.'));
    if (!defect.empty() && !draws_damaged)
        refuse(file, "the file is damaged: " + defect +
                         ". With --damaged draw, what is whole of it is drawn.");
    return {file,
            std::move(mesh),
            {readable(name.u8string()), hash.get()},
            readable(name.stem().u8string()),
            defect,
            remark};
}
