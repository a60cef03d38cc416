// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing_dialog.h"

#include "line_drawing/view_frame.h"
#include "line_drawing/words.h"

namespace {

const char* const all_sides = "six";

QStringList sides() {
    QStringList names;
    for (const char* name : line_drawing::sideNames())
        names << QString(name).toLower();
    return names;
}

/// A pair of angles is one word, "six" its sides.
QStringList viewsIn(const QString& text) {
    QStringList views;
    QStringList words;
    for (const std::string& word : line_drawing::wordsOf(text.toLower().toStdString()))
        words << QString::fromStdString(word);
    for (int i = 0; i < words.size(); ++i) {
        bool is_number = false;
        words[i].toDouble(&is_number);
        if (words[i] == all_sides)
            views << sides();
        else if (is_number && i + 1 < words.size())
            views << words[i] + "," + words[i + 1], ++i;
        else
            views << words[i];
    }
    return views;
}

}  // namespace

QStringList viewsWithMarks() {
    return QStringList{window_view} + sides() + QStringList{"vessel"};
}

bool hasView(const QString& text, const QString& view) {
    return viewsIn(text).contains(view);
}

QString withView(const QString& text, const QString& view, bool is_wanted) {
    QStringList views = viewsIn(text);
    if (!is_wanted)
        views.removeAll(view);
    else if (!views.contains(view))
        views << view;
    return views.join(", ");
}
