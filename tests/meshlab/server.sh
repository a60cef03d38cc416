#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The program that stands in for meshlabserver from MeshLab 2022.02 on: needs no display, gives the core's results, and
# ends with a sentence and an exit code when something is wrong.
source "$(dirname "$(readlink -f "$0")")/harness.sh"
unset DISPLAY

# refuse CODE REASON ARGS...: it ends with this code and reason, and writes no mesh
refuse() {
    local code=$1 reason=$2
    shift 2
    rm -f "$WORK/none.ply"
    serve "$@"
    ((SERVER_CODE == code)) || fail "$* ended with $SERVER_CODE instead of $code"
    expect_text "$WORK/log" "$reason"
    [[ ! -e $WORK/none.ply ]] || fail "$* wrote a mesh"
}

# refuse_script REASON SED_EXPRESSION: the example, changed
refuse_script() {
    sed "$2" "$EXAMPLE" >"$WORK/changed.mlx"
    ! cmp -s "$EXAMPLE" "$WORK/changed.mlx" || fail "the example has nothing that matches $2"
    refuse 1 "$1" -i torus.ply -s changed.mlx -o none.ply
}

reference_mesh torus
serve -i torus.ply -s "$EXAMPLE" -o out.ply -m va
((SERVER_CODE == 0)) || fail "the example ended with $SERVER_CODE"
expect_reference_attributes "$WORK/out.ply"

refuse_script 'There is no filter "Compute Laplacian"\. Similar ones: Compute Laplacian Lines' 's/Compute Laplacian Lines"/Compute Laplacian"/'
refuse_script 'There is no parameter acuracy\. There are: kernel_size, ' 's/name="accuracy"/name="acuracy"/'
refuse_script 'Parameter accuracy: "much" is not a number' 's/value="0.001"/value="much"/'
refuse_script 'Parameter kernel_size: the type RichLength cannot be read' 's/RichAbsPerc/RichLength/'
refuse_script 'Parameter accuracy has the type RichFloat, not RichBool' 's/RichFloat" value="0.001"/RichBool" value="true"/'
refuse_script '"Kernel" is 7\. It has to be one of 0 \(Uniform\), 1 \(Adaptive\)' 's/\(name="kernel_mode".* value="\)0/\17/'
refuse_script 'is not XML: line [0-9]+' 's/<.FilterScript>//'
refuse_script 'is not a MeshLab filter script: its root is <Filters>' 's/FilterScript>/Filters>/'
refuse_script 'has no filter' 's/<filter /<filters /; s/<.filter>/<\/filters>/'

printf 'ply\nformat ascii 1.0\nelement vertex 5\n' >"$WORK/broken.ply"
refuse 1 'missing\.ply cannot be read: No such file' -i missing.ply -o none.ply
refuse 1 'broken\.ply' -i broken.ply -o none.ply
refuse 1 'missing\.mlx cannot be read: No such file' -i torus.ply -s missing.mlx -o none.ply
refuse 1 'There is no mesh\. Open one with -i' -s "$EXAMPLE" -o none.ply
refuse 1 'There is no mesh to save' -o none.ply
refuse 1 'no_folder/none\.ply cannot be written: No such file' -i torus.ply -o no_folder/none.ply
refuse 1 'none\.xyzw' -i torus.ply -o none.xyzw
refuse 1 'There is no layer 2 to save .* the last one is 0' -i torus.ply -o none.ply -l 2
refuse 1 'other\.so does not exist' --plugin other.so -i torus.ply -o none.ply
refuse 2 'unknown argument -q' -q
refuse 2 '-i needs the name of a file' -i -o none.ply
refuse 2 '-m does not know vv' -i torus.ply -o none.ply -m vn vv
refuse 2 '-l after -o needs a layer' -i torus.ply -o none.ply -l first

# layers, masks, the log, projects
sphere=$WORK/sphere.obj
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n' >"$sphere"
serve -l said.txt -i torus.ply sphere.obj -o current.ply -m vn vc sa -o first.ply -l 0 -o last.stl -l x -w both.mlp
((SERVER_CODE == 0)) || fail "saving layers ended with $SERVER_CODE"
expect_text "$WORK/current.ply" '^element vertex 4$'
expect_text "$WORK/current.ply" '^format ascii'
expect_text "$WORK/current.ply" '^property float nx$'
grep -aq '^element vertex 3200$' "$WORK/first.ply" || fail "-l 0 did not save the first layer"
! grep -aq 'property float nx' "$WORK/first.ply" || fail "normals were saved unasked"
expect_text "$WORK/said.txt" '^opened .*torus\.ply: 3200 vertices, 6400 faces$'
serve -p both.mlp -o again.ply -l 0
((SERVER_CODE == 0)) || fail "the project could not be opened: $SERVER_CODE"
cmp "$WORK/again.ply" "$WORK/first.ply" || fail "the project's mesh is another one"
[[ -s $WORK/sphere_out.obj && -s $WORK/torus_out.ply ]] || fail "the project's meshes are not where they should be"

serve -d filters.txt
expect_text "$WORK/filters.txt" '^Compute Laplacian Lines$'
expect_text "$WORK/filters.txt" '^    gradient_radius \(RichFloat\): Gradient Radius$'

# serve_within KB ARGS...: with so much address space
serve_within() {
    ulimit -Sv "$1"
    serve "${@:2}"
    ulimit -Sv unlimited
}

# What a small mesh needs, within 8 MB, is not enough for a large one: it says so and writes nothing.
least=0 enough=8388608
while ((enough - least > 8192)); do
    middle=$(((least + enough) / 2))
    serve_within $middle -i torus.ply -s "$EXAMPLE" -o small.ply
    if ((SERVER_CODE == 0)); then enough=$middle; else least=$middle; fi
done
write_bumpy_torus 800 500 >"$WORK/large.ply"
for more in 8192 32768 65536 98304; do
    serve_within $((enough + more)) -i large.ply -s "$EXAMPLE" -o none.ply
    ((SERVER_CODE == 1)) || fail "$more KB more than a small mesh needs: it ended with $SERVER_CODE"
    grep -qi 'not enough memory' "$WORK/log" || fail "$more KB more than a small mesh needs: it does not say why it fails"
    [[ ! -e $WORK/none.ply ]] || fail "$more KB more than a small mesh needs: it wrote a mesh"
done
