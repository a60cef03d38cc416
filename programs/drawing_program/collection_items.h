// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <vector>

#include "line_drawing/sheet.h"

struct CollectionItem {
    QString mesh;     ///< its file
    QString name;     ///< of its drawing, without ending; no two have the same
    QByteArray hash;  ///< SHA-256 of its file
    QByteArray key;   ///< tells mesh, options and program from others
};

/// The named meshes and those in named folders. Equal names of drawings get the mesh's extension.
/// @throws laplacian_lines::Error(InvalidOption) if there are none, or names stay equal
std::vector<CollectionItem> itemsOf(const QStringList& named, const QStringList& options,
                                    const QStringList& taken_names);

/// Drawings of a collection with the records of what they show.
struct CollectionFolder {
    QString path, format;

    QString recordFolder() const;
    QString drawingOf(const CollectionItem& item) const;
    QString viewOf(const CollectionItem& item) const;  ///< for the contact sheet

    /// Whether there is a drawing with this key.
    bool isUpToDate(const CollectionItem& item) const;
    void remember(const CollectionItem& item) const;
    void forget(const CollectionItem& item) const;

    /// @throws laplacian_lines::Error(InvalidOption)
    line_drawing::Sheet readView(const CollectionItem& item) const;

private:
    QString recordOf(const CollectionItem& item) const;
};
