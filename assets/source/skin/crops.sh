#!/bin/sh
# Makes docs/images/skin/crops.jpg, from the project's folder: nose, ear and terminator of the head in the study
# modules/skin/studies/truth.json, path-traced and by each technique. Needs oiiotool (Debian's openimageio-tools).
#
#   assets/source/skin/crops.sh [PROGRAM] [SHEET]
#
# Rows: nose, ear, terminator. Columns: the trace, lambert, wrap, blurred_normals, preintegrated, two_gaussians,
# separable, disc, six_gaussians, hable. The oily layer is as rough as the trace's boundary, as in the study. All go
# from radiance through the engine's view "sRGB" at exposure 1, and are taken from 64x64 mean pixels, as the trace has
# them, to tiles of 160x160.
set -eu
program=${1:-build/release/bin/tyndall}
sheet=${2:-docs/images/skin/crops.jpg}
studies=modules/skin/studies
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT

"$program" capture "$studies/crops.json" --set '/entities/Head/skin/lobe_roughness=[1, 1]' --exr --out "$out"
tiles=
for part in nose ear terminator; do
    for picture in "$studies/crop_$part.exr" $(for technique in lambert wrap blurred_normals preintegrated \
        two_gaussians separable disc six_gaussians hable; do echo "$out/crops-${part}_$technique.exr"; done); do
        tile=$out/$part-$(basename "$picture" .exr).png
        oiiotool --colorconfig config/color/tyndall.ocio "$picture" --ch R,G,B --resize:filter=box 64x64 \
            --resize:filter=triangle 160x160 --iscolorspace "Linear Rec.709" --ociodisplay sRGB sRGB -d uint8 -o "$tile"
        tiles="$tiles $tile"
    done
done
# file names without blanks: mktemp's folder has none
# shellcheck disable=SC2086
oiiotool $tiles --mosaic:pad=2 10x3 --compression jpeg:90 -o "$sheet"
