// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawings.h"

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <new>
#include <shared_mutex>
#include <thread>

#include "laplacian_lines/threads.h"
#include "line_drawing/atomic_file.h"
#include "line_drawing/make_sheet.h"
#include "mesh_reading.h"

namespace fs = std::filesystem;
using line_drawing::Sheet;

namespace {

const char* const kContactName = "contact_sheet";

// Measured: six views of a part of 84,000 triangles with many edges take 6.7 kB a triangle, of a
// scan with 14 million 180 bytes.
constexpr double kBytesPerTriangle = 8e3;
constexpr double kShareOfFreeMemory = 0.8;

/// File names, incomplete ones marked by a word before them, since notes may be truncated.
std::string note_of(const std::vector<ReadMesh>& meshes) {
    Words names;
    for (const ReadMesh& read : meshes) {
        names.push_back((read.defect.empty() ? "" : "incomplete: ") + read.source.name);
        if (!read.defect.empty()) say(stderr, read.file + " is drawn incomplete: " + read.defect);
    }
    return line_drawing::joined(names, ", ");
}

/// With the meshes' names.
line_drawing::SheetOptions options_for(const std::vector<ReadMesh>& meshes,
                                       line_drawing::SheetOptions options) {
    Words titles;
    for (const ReadMesh& read : meshes)
        titles.push_back(read.title);
    options.title = line_drawing::title_of(options.title, titles);
    options.source = note_of(meshes);
    return options;
}

/// Reads a mesh as the options say, and says what of its file was skipped.
ReadMesh read_and_report(const std::string& file, const CommandLine& commands) {
    ReadMesh read = read_mesh(file, commands.choices.draws_damaged);
    if (!read.remark.empty()) say(stderr, file + ": " + read.remark);
    return read;
}

std::vector<line_drawing::SourceMesh> sources_of(const std::vector<ReadMesh>& meshes) {
    std::vector<line_drawing::SourceMesh> sources;
    for (const ReadMesh& read : meshes)
        sources.push_back(read.source);
    return sources;
}

/// Draws the meshes together into the file. Returns the sheet and, of a collection, the mesh's view
/// for the contact sheet. @throws laplacian_lines::Error with a sentence for users; std::bad_alloc
std::vector<Sheet> draw_into(const std::string& file, const std::vector<ReadMesh>& meshes,
                             const CommandLine& commands) {
    std::vector<line_drawing::SheetOptions> options = {options_for(meshes, commands.options)};
    const std::vector<std::string> remarks = line_drawing::check_texts(options[0], file);
    if (commands.is_collection)
        options.push_back(line_drawing::contact_options(meshes.front().mesh, options[0]));
    line_drawing::Objects objects;
    for (const ReadMesh& read : meshes)
        objects.push_back({read.mesh, nullptr, read.file});
    std::vector<Sheet> sheets = line_drawing::make_sheets(objects, options);
    sheets[0].provenance = line_drawing::provenance_text(sources_of(meshes), commands.words);
    line_drawing::write_atomically(file, write_sheet(sheets[0], file, commands.choices.dpi));
    for (const auto& all : {remarks, sheets[0].remarks})
        for (const std::string& remark : all)
            say(stderr, (commands.is_collection ? meshes.front().file + ": " : "") + remark);
    return sheets;
}

/// Says the size: scans may be in metres, and files have no unit.
void say_size(const std::vector<ReadMesh>& meshes, const CommandLine& commands) {
    Eigen::AlignedBox3d box;
    for (const ReadMesh& read : meshes)
        box.extend(line_drawing::bounds_of(read.mesh));
    if (box.isEmpty()) return;
    const double unit = commands.options.mm_per_unit;
    const Eigen::Vector3d size = unit * box.sizes();
    const bool is_given =
        std::find(commands.words.begin(), commands.words.end(), "--unit") != commands.words.end();
    const char* advice = is_given              ? ""
                         : size.maxCoeff() < 1 ? "; if it is in metres, say --unit m"
                                               : "; --unit says otherwise";
    say(stdout, (meshes.size() > 1 ? "together the objects are " : "the object is ") +
                    line_drawing::size_text(size, " x ") + " in size, with " +
                    line_drawing::in_digits(unit) + " mm to the unit of the mesh" + advice);
}

double free_memory() {
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
        std::vector<std::thread> threads;
        for (int i = 0; i < thread_count_; ++i)
            threads.emplace_back([this] {
                for (std::size_t k; (k = next_++) < items_.size();)
                    draw_catching_all(items_[k]);
            });
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

void draw_one(const CommandLine& commands) {
    line_drawing::check_writable(commands.drawing);
    std::vector<ReadMesh> meshes;
    for (const std::string& file : commands.meshes)
        meshes.push_back(read_and_report(file, commands));
    if (commands.like) say_what_differs(*commands.like, sources_of(meshes));
    say_size(meshes, commands);
    draw_into(commands.drawing, meshes, commands);
    say(stdout, "the drawing is " + commands.drawing);
}

bool draw_collection(const CommandLine& commands) {
    return Collection(commands).draw();
}
