// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <new>
#include <shared_mutex>
#include <system_error>
#include <thread>

#include "drawings.h"
#include "laplacian_lines/threads.h"
#include "line_drawing/atomic_file.h"
#include "line_drawing/make_sheet.h"

namespace fs = std::filesystem;
using line_drawing::Sheet;

namespace {

const char* const kContactName = "contact_sheet";

// Measured: six views of a part of 84,000 triangles with many edges take 6.7 kB a triangle, of a
// scan with 14 million 180 bytes.
constexpr double kBytesPerTriangle = 8e3;
constexpr double kShareOfFreeMemory = 0.8;

/// Bytes; a guess where the system does not tell.
double free_memory() {
    std::ifstream file("/proc/meminfo");
    for (std::string key, rest; file >> key; std::getline(file, rest))
        if (double kilobytes = 0; key == "MemAvailable:" && file >> kilobytes)
            return 1024 * kilobytes;
    return 4e9;
}

/// A mesh of the collection.
struct Item {
    std::string mesh;  ///< its file
    std::string name;  ///< of its drawing's file, without folder and extension
    std::optional<line_drawing::SourceMesh> source = {};  ///< if it was drawn
    Sheet contact_view = {};
};

/// Drawings whose names would be equal get the mesh's extension.
/// @throws laplacian_lines::Error(InvalidOption) if they stay equal
std::vector<Item> items_of(const Words& meshes) {
    std::map<std::string, int> counts = {{kContactName, 1}};
    for (const std::string& mesh : meshes)
        ++counts[fs::u8path(mesh).stem().u8string()];
    std::vector<Item> items;
    std::map<std::string, std::string> taken;
    for (const std::string& mesh : meshes) {
        const fs::path file = fs::u8path(mesh);
        const std::string stem = file.stem().u8string(),
                          name = counts[stem] > 1 ? file.filename().u8string() : stem;
        const auto [place, is_new] = taken.emplace(name, mesh);
        if (!is_new)
            line_drawing::refuse("\"" + place->second + "\" and \"" + mesh +
                                 "\" have the same name, and so would their drawings.");
        items.push_back({mesh, name});
    }
    return items;
}

/// Creates a folder; removes what it has created at the end, unless there is anything in it.
class Folder {
public:
    explicit Folder(const fs::path& name) {
        std::error_code none;
        for (fs::path part = name; !part.empty() && !fs::exists(part, none);
             part = part.parent_path())
            made_.push_back(part);
        fs::create_directories(name, none);
    }
    ~Folder() {
        std::error_code none;
        for (const fs::path& part : made_)
            fs::remove(part, none);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

private:
    std::vector<fs::path> made_;  // inner ones first
};

/// Threads take one mesh after the other, and the contact sheet follows from what they have drawn.
class Collection {
public:
    explicit Collection(const CommandLine& commands)
        : commands_(commands),
          items_(items_of(commands.meshes)),
          folder_(fs::u8path(commands.drawing)) {
        line_drawing::check_writable(file_of(kContactName));
    }

    /// Whether all were drawn.
    bool draw() {
        const auto draw_next = [this] {
            for (std::size_t k; (k = next_++) < items_.size();)
                draw_catching_all(items_[k]);
        };
        std::vector<std::thread> threads;
        try {
            for (int i = 1; i < thread_count_; ++i)
                threads.emplace_back(draw_next);
        } catch (const std::system_error&) {  // those that started take all
        }
        draw_next();
        for (std::thread& thread : threads)
            thread.join();
        write_contact_sheet();
        const auto drawn = std::count_if(items_.begin(), items_.end(),
                                         [](const Item& item) { return item.source.has_value(); });
        const auto failed = std::ptrdiff_t(items_.size()) - drawn;
        say(stdout, std::to_string(drawn) + " drawn, " + std::to_string(failed) + " not drawn");
        return failed == 0;
    }

private:
    std::string file_of(const std::string& name) const {
        return (fs::u8path(commands_.drawing) / fs::u8path(name + commands_.choices.file))
            .u8string();
    }

    void draw_catching_all(Item& item) {
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
        meshes.push_back(read_and_report(item.mesh, commands_));
        std::shared_lock with_others(memory_, std::defer_lock);
        std::unique_lock alone(memory_, std::defer_lock);
        if (kBytesPerTriangle * double(meshes[0].mesh.triangles.size()) > memory_of_thread_)
            alone.lock();
        else
            with_others.lock();
        const std::string file = file_of(item.name);
        item.contact_view = draw_into(file, meshes, commands_).at(1);
        item.source = meshes[0].source;
        say(stdout, file + ": drawn");
    }

    void write_contact_sheet() const {
        std::vector<line_drawing::ContactEntry> entries;
        std::vector<line_drawing::SourceMesh> meshes;
        for (const Item& item : items_)
            if (item.source) {
                entries.push_back({readable(item.name), item.contact_view});
                meshes.push_back(*item.source);
            }
        if (entries.empty()) return;
        const std::string file = file_of(kContactName), &title = commands_.options.title;
        Sheet sheet = line_drawing::make_contact_sheet(
            entries, title.find("{name}") == title.npos ? title : std::string());
        if (commands_.options.text == line_drawing::TextStyle::Outlines)
            line_drawing::outline_texts(sheet);
        sheet.provenance = line_drawing::provenance_text(meshes, commands_.words);
        line_drawing::write_atomically(file, write_sheet(sheet, file, commands_.choices.dpi));
        for (const std::string& remark : sheet.remarks)
            say(stderr, file + ": " + remark);
        say(stdout, file + ": " + std::to_string(entries.size()) +
                        (entries.size() == 1 ? " object" : " objects"));
    }

    const CommandLine& commands_;
    std::vector<Item> items_;
    const Folder folder_;
    std::atomic<std::size_t> next_{0};
    const int thread_count_ = std::min(laplacian_lines::thread_limit(), int(items_.size()));
    const double memory_of_thread_ = kShareOfFreeMemory * free_memory() / thread_count_;
    std::shared_mutex memory_;  ///< held by large meshes alone
};

}  // namespace

bool draw_collection(const CommandLine& commands) {
    return Collection(commands).draw();
}
