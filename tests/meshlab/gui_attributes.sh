#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The filter's attributes in a PLY file that MeshLab saves: on a torus they are close to what mathematics says, and the
# mesh itself stays as it was.
source "$(dirname "$(readlink -f "$0")")/harness.sh"

# Radii 1 and 0.4, axis z; the bumpy one without its bumps
write_bumpy_torus 240 120 | awk -v sides=120 '
    /^end_header/ { inside = 1; print; next }
    inside && NF == 3 {
        turn = 8 * atan2(1, 1)
        u = turn * int(n / sides) / 240
        v = turn * (n % sides) / sides
        n++
        printf "%.6f %.6f %.6f\n", (1 + 0.4 * cos(v)) * cos(u), (1 + 0.4 * cos(v)) * sin(u), 0.4 * sin(v)
        next
    }
    { print }' >"$WORK/torus.ply"
cp "$WORK/torus.ply" "$WORK/before.ply"
drive < <(
    cat <<'END'
wait
open torus.ply
trigger Compute Laplacian Lines
apply
close
END
    save_attributes off
)

# From 2022.02 on, MeshLab writes a point attribute as a list, its length 3 glued to the number before it.
awk '/^property list uchar float ll_/ { lists = 1 }
    lists && NF == 17 {
        $5 = ""
        for (i = 8; i < 17; i += 3) sub(/3$/, "", $i)
        $0 = $0
        $1 = $1
    }
    { print }' "$WORK/torus.ply" >"$WORK/columns.ply"

# Columns of the file: x y z, kernel size, Δn, n, diagonal and rest of S. |A|² is the sum of the squared curvatures.
largest_errors() {
    awk '
        function worse(name, error) { if (error < 0) error = -error; if (!(error <= worst[name])) worst[name] = error }
        NF == 16 {
            rho = sqrt($1 * $1 + $2 * $2); c = (rho - 1) / 0.4; s = $3 / 0.4; k = 1 / 0.4; l = c / rho
            ex = $1 / rho; ey = $2 / rho; nx = c * ex; ny = c * ey; nz = s
            worse("normal", 1 - ($8 * nx + $9 * ny + $10 * nz))
            worse("laplacian", (($5 * nx + $6 * ny + $7 * nz) / (k * k + l * l)) + 1)
            worse("shape", ($11 - k * s * s * ex * ex - l * ey * ey) / k)
            worse("shape", ($12 - k * s * s * ey * ey - l * ex * ex) / k)
            worse("shape", ($13 - k * c * c) / k)
            worse("shape", ($14 + k * s * c * ey) / k)
            worse("shape", ($15 + k * s * c * ex) / k)
            worse("shape", ($16 - (k * s * s - l) * ex * ey) / k)
            worse("kernel", $4 / 0.053984 - 1)
            ++n
        }
        END { print n, worst["normal"] + 0, worst["laplacian"] + 0, worst["shape"] + 0, worst["kernel"] + 0 }' "$1"
}

read -r vertices normal laplacian shape kernel < <(largest_errors "$WORK/columns.ply")
say "$vertices vertices; largest errors: normal $normal, laplacian $laplacian, shape operator $shape, kernel $kernel"
awk "BEGIN { exit !($vertices == 28800 && $normal < 1e-4 && $laplacian < 0.02 && $shape < 0.02 && $kernel < 1e-4) }" ||
    fail "the attributes are not those of a torus"

geometry() {
    # some awks keep the sign of a zero
    awk '/^element/ || /^3 / { $1 = $1; print; next } /^[-0-9]/ && (NF == 3 || NF == 16) { printf "%.5f %.5f %.5f\n", $1, $2, $3 }' "$1" | sed 's/-0\.00000/0.00000/g'
}
diff <(geometry "$WORK/before.ply") <(geometry "$WORK/columns.ply") >/dev/null || fail "the filter changed the mesh"
