// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>
#include <optional>

class QObject;
class QWidget;

namespace meshlab_host {

/// A filter's dialog, for which MeshLab lists a label and an editor per parameter. Adds widgets and
/// writes into editors like a user. Fields are found by their labels; missing ones are ignored. GUI
/// thread only.
class FilterDialog {
public:
    /// Calls `furnish` when the dialog opens, unless it has been furnished.
    static void whenOpen(const QString& filter, std::function<void(FilterDialog)> furnish);
    static bool isOpen(const QString& filter);

    /// Holds the fields.
    QWidget* frame() const { return frame_; }

    /// "on" or "off" for a switch.
    std::optional<QString> text(const QString& label) const;
    /// Ignores unknown choices.
    void setText(const QString& label, const QString& text);
    /// Whoever changes a field.
    void whenChanged(const QObject* receiver, const std::function<void()>& changed);

    /// The dialog grows. False if there is no such field.
    bool addBelow(const QString& label, QWidget* widget);
    bool addBeside(const QString& label, QWidget* widget);
    void addLine(QWidget* widget);
    /// Reduces the spacing, for small screens.
    void tighten();

private:
    explicit FilterDialog(QWidget* frame) : frame_(frame) {}
    static QWidget* find(const QString& filter);
    bool addTo(const QString& label, QWidget* widget, bool below);
    void fit();
    int missingHeight() const;

    QWidget* frame_;
};

}  // namespace meshlab_host
