// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <new>
#include <shared_mutex>
#include <thread>

#include "drawings.h"
#include "laplacian_lines/threads.h"
#include "line_drawing/make_sheet.h"
#include "line_drawing/whole_file.h"

namespace fs = std::filesystem;
using line_drawing::Sheet;

namespace {

const char* const contact_name = "contact_sheet";

// Measured: six views of a part of 84,000 triangles with many edges take 6.7 kB a triangle, of a
// scan with 14 million 180 bytes.
constexpr double bytes_per_triangle = 8e3;
constexpr double share_of_free_memory = 0.8;

double freeMemory() {
    std::ifstream file("/proc/meminfo");
    for (std::string key, rest; file >> key; std::getline(file, rest))
        if (double kilobytes = 0; key == "MemAvailable:" && file >> kilobytes)
            return 1024 * kilobytes;
    return 4e9;
}

struct Item {
    std::string mesh, name;  ///< their files, without folder and ending of the drawing's
    std::optional<line_drawing::SourceMesh> source = {};  ///< if it was drawn
    Sheet contact_view = {};
};

/// Drawings whose names would be equal get the mesh's extension.
/// @throws laplacian_lines::Error(InvalidOption) if they stay equal
std::vector<Item> itemsOf(const Words& meshes) {
    std::map<std::string, int> counts = {{contact_name, 1}};
    for (const fs::path mesh : meshes)
        ++counts[mesh.stem().string()];
    std::vector<Item> items;
    std::map<std::string, std::string> taken;
    for (const fs::path mesh : meshes) {
        const std::string stem = mesh.stem().string(),
                          name = counts[stem] > 1 ? mesh.filename().string() : stem;
        const auto [place, is_new] = taken.emplace(name, mesh.string());
        if (!is_new)
            line_drawing::refuse("\"" + place->second + "\" and \"" + mesh.string() +
                                 "\" have the same name, and so would their drawings.");
        items.push_back({mesh.string(), name});
    }
    return items;
}

class Collection {
public:
    explicit Collection(const CommandLine& commands)
        : commands_(commands), items_(itemsOf(commands.meshes)) {
        std::error_code none;
        fs::create_directories(commands.drawing, none);
        line_drawing::checkWritable(fileOf(contact_name));
    }

    /// Whether all were drawn.
    bool draw() {
        std::vector<std::thread> threads;
        for (int i = 0; i < thread_count_; ++i)
            threads.emplace_back([this] {
                for (std::size_t k; (k = next_++) < items_.size();)
                    drawCatchingAll(items_[k]);
            });
        for (std::thread& thread : threads)
            thread.join();
        writeContactSheet();
        const auto drawn = std::count_if(items_.begin(), items_.end(),
                                         [](const Item& item) { return item.source.has_value(); });
        const auto failed = std::ptrdiff_t(items_.size()) - drawn;
        say(stdout, std::to_string(drawn) + " drawn, " + std::to_string(failed) + " not drawn");
        return failed == 0;
    }

private:
    std::string fileOf(const std::string& name) const {
        return (fs::path(commands_.drawing) / (name + '.' + commands_.format())).string();
    }

    void drawCatchingAll(Item& item) {
        std::string why = "not enough memory";
        try {
            return draw(item);
        } catch (const std::bad_alloc&) {
        } catch (const std::exception& error) {
            why = error.what();
        }
        const std::string name = item.mesh + ": ";
        if (why.substr(0, name.size()) == name) why.erase(0, name.size());
        say(stderr, name + "not drawn: " + why);
    }

    /// Large meshes are drawn one at a time.
    void draw(Item& item) {
        std::vector<ReadMesh> meshes;
        meshes.push_back(readAloud(item.mesh, commands_));
        std::shared_lock with_others(memory_, std::defer_lock);
        std::unique_lock alone(memory_, std::defer_lock);
        if (bytes_per_triangle * double(meshes[0].mesh.triangles.size()) > memory_of_thread_)
            alone.lock();
        else
            with_others.lock();
        const std::string file = fileOf(item.name);
        item.contact_view = drawInto(file, meshes, commands_).at(1);
        item.source = meshes[0].source;
        say(stdout, file + ": drawn");
    }

    void writeContactSheet() const {
        std::vector<line_drawing::ContactEntry> entries;
        std::vector<line_drawing::SourceMesh> meshes;
        for (const Item& item : items_)
            if (item.source) {
                entries.push_back({readable(item.name), item.contact_view});
                meshes.push_back(*item.source);
            }
        if (entries.empty()) return;
        const std::string file = fileOf(contact_name), &title = commands_.options.title;
        Sheet sheet = line_drawing::makeContactSheet(
            entries, title.find("{name}") == title.npos ? title : std::string());
        if (commands_.options.text == line_drawing::TextStyle::Outlines)
            line_drawing::outlineTexts(sheet);
        sheet.provenance = line_drawing::provenanceText(meshes, commands_.words);
        line_drawing::writeWhole(file, writeSheet(sheet, file, commands_.choices.dpi));
        say(stdout, file + ": " + std::to_string(entries.size()) + " objects");
    }

    const CommandLine& commands_;
    std::vector<Item> items_;
    std::atomic<std::size_t> next_{0};
    const int thread_count_ = std::min(laplacian_lines::thread_limit(), int(items_.size()));
    const double memory_of_thread_ = share_of_free_memory * freeMemory() / thread_count_;
    std::shared_mutex memory_;  ///< held by large meshes alone
};

}  // namespace

bool drawCollection(const CommandLine& commands) {
    return Collection(commands).draw();
}
