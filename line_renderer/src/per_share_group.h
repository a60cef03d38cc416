// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QOpenGLContext>
#include <exception>
#include <map>
#include <optional>
#include <stdexcept>

namespace line_renderer {

/// Names the set of OpenGL contexts that share objects with the current one: all views of one
/// document. Null if no context is current. The name is only good for comparing.
using ShareGroup = const QOpenGLContextGroup*;

/// An Object for each share group of OpenGL contexts, made when it is first asked for there. It is
/// forgotten, not deleted in OpenGL, when the group dies, which takes all OpenGL objects with it.
/// GUI thread only.
template <class Object>
class PerShareGroup {
public:
    /// That of the current context's group, made by `make()` if there is none. A
    /// std::runtime_error of `make` is thrown again by each later call for this group, without
    /// another try; other exceptions pass through.
    template <class Make>
    Object& current(Make make) {
        const ShareGroup group = QOpenGLContextGroup::currentContextGroup();
        const auto [place, is_new] = entries_.try_emplace(group);
        Entry& entry = place->second;
        if (is_new && group)
            QObject::connect(group, &QObject::destroyed, &receiver_,
                             [this, group] { entries_.erase(group); });
        if (entry.failure) std::rethrow_exception(entry.failure);
        if (!entry.object) fill(entry, make);
        return *entry.object;
    }
    /// The same, made by its default constructor.
    Object& current() {
        return current([] { return Object(); });
    }

    /// visit(Object&) for those of all groups.
    template <class Visit>
    void forEach(Visit visit) {
        for (auto& entry : entries_)
            if (entry.second.object) visit(*entry.second.object);
    }

private:
    struct Entry {
        std::optional<Object> object;
        std::exception_ptr failure;
    };

    template <class Make>
    static void fill(Entry& entry, Make& make) {
        try {
            entry.object.emplace(make());
        } catch (const std::runtime_error&) {
            entry.failure = std::current_exception();
            throw;
        }
    }

    std::map<ShareGroup, Entry> entries_;
    QObject receiver_;  ///< of the groups' last words; destroyed first
};

}  // namespace line_renderer
