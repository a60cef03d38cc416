// SPDX-License-Identifier: GPL-3.0-or-later
#include "like.h"

#include <algorithm>

#include "file_names.h"
#include "laplacian_lines/version.h"
#include "line_drawing/words.h"

using line_drawing::Provenance;

namespace {

/// Files come from anywhere: what they say must not name others.
bool isOption(const QString& word) {
    return word.startsWith("--") && word != "--" && word != "--like" && word != "--contact-view";
}

}  // namespace

Provenance likeOf(const QString& file) {
    Provenance like = line_drawing::provenanceOf(file);
    bool are_pairs = like.options && like.options->size() % 2 == 0;
    for (int i = 0; are_pairs && i < like.options->size(); i += 2)
        are_pairs = isOption((*like.options)[i]);
    if (!are_pairs)
        line_drawing::refuse(
            QString("\"%1\" has no options of this command: it was drawn in another way.")
                .arg(file));
    return like;
}

void sayWhatDiffers(const Provenance& like, const std::vector<Provenance::Mesh>& meshes) {
    if (like.version != laplacian_lines::version())
        say(stderr, QString("it was drawn like that by version %1, and is now by %2")
                        .arg(like.version, laplacian_lines::version()));
    if (like.meshes.size() != meshes.size())
        say(stderr, QString("it was drawn like that of %1 meshes, and is now of %2")
                        .arg(like.meshes.size())
                        .arg(meshes.size()));
    for (const Provenance::Mesh& mesh : meshes)
        if (std::none_of(like.meshes.begin(), like.meshes.end(),
                         [&](const Provenance::Mesh& m) { return m.sha256 == mesh.sha256; }))
            say(stderr, QString("%1 is not a mesh that was drawn like that: its bytes are others")
                            .arg(mesh.name));
}
