# SPDX-License-Identifier: GPL-3.0-or-later
# A home folder for one run of MeshLab, so that the user's settings neither matter nor change.

# use_private_home FOLDER
use_private_home() {
    local home=$1
    mkdir -p "$home/.config/VCG" "$home/runtime"
    chmod 700 "$home/runtime"
    export HOME=$home XDG_CONFIG_HOME=$home/.config XDG_CACHE_HOME=$home/.cache XDG_DATA_HOME=$home/.local/share
    export XDG_RUNTIME_DIR=$home/runtime
    unset QT_STYLE_OVERRIDE QT_QPA_PLATFORMTHEME QT_SCALE_FACTOR QT_AUTO_SCREEN_SCALE_FACTOR QT_SCREEN_SCALE_FACTORS
    export LC_ALL=C.UTF-8
}

# set_colour HOME NAME R G B: MeshLab keeps each setting as a small XML text under its own name.
set_colour() {
    local file=$1/.config/VCG/MeshLab_64bit_fp.conf name=$2
    [[ -s $file ]] || printf '[General]\n' >"$file"
    printf 'MeshLab%%3A%%3AAppearance%%3A%%3A%s="%s"\n' "$name" \
        "<Param type=\\\"RichColor\\\" name=\\\"MeshLab::Appearance::$name\\\" r=\\\"$3\\\" g=\\\"$4\\\" b=\\\"$5\\\" a=\\\"255\\\" description=\\\"\\\" tooltip=\\\"\\\"/>" \
        >>"$file"
}

white_background() {
    set_colour "$1" backgroundBotColor 255 255 255
    set_colour "$1" backgroundTopColor 255 255 255
}
