// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QOpenGLContext>
#include <exception>
#include <map>
#include <optional>
#include <stdexcept>

namespace line_renderer {

/// The contexts that share objects with the current one: all views of a document. Null without a
/// current context. Only compared.
using ShareGroup = const QOpenGLContextGroup*;

/// An Object per share group, made on demand. When the group dies, taking its OpenGL objects along,
/// it is forgotten, not deleted. GUI thread only.
template <class Object>
class PerShareGroup {
public:
    /// For the current group, made by `make()`, whose std::runtime_error every later call for the
    /// group throws again without another try; other exceptions pass through.
    template <class Make>
    Object& current(Make make) {
        const ShareGroup group = QOpenGLContextGroup::currentContextGroup();
        const auto [place, is_new] = entries_.try_emplace(group);
        Entry& entry = place->second;
        if (is_new && group)
            QObject::connect(group, &QObject::destroyed, &receiver_,
                             [this, group] { entries_.erase(group); });
        if (entry.failure) std::rethrow_exception(entry.failure);
        if (entry.object) return *entry.object;
        try {
            return entry.object.emplace(make());
        } catch (const std::runtime_error&) {
            entry.failure = std::current_exception();
            throw;
        }
    }
    /// By the default constructor.
    Object& current() {
        return current([] { return Object(); });
    }

    template <class Visit>
    void for_each(Visit visit) {
        for (auto& entry : entries_)
            if (entry.second.object) visit(*entry.second.object);
    }

private:
    struct Entry {
        std::optional<Object> object;
        std::exception_ptr failure;
    };

    std::map<ShareGroup, Entry> entries_;
    QObject receiver_;  ///< of the groups' signals; destroyed first
};

}  // namespace line_renderer
