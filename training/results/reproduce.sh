#!/bin/bash
# Trains and evaluates everything that the pages of this folder show; ended and started again it
# goes on. With `--part PART` of experiment.toml, that part alone.
#   bash training/results/reproduce.sh DATA OUT [OPTION OF nscc sweep ...]
# DATA holds hdr/*.hdr (24 panoramas, 512 x 1024), video/*.mp4 and sci/*.mat. Links to them, and for
# the whole experiment photographs that training/data/fetch.py fetches, come into the folder `data`
# beside this file.
set -euo pipefail

data=$(realpath "$1") out=$(realpath -m "$2")
shift 2
cd "$(dirname "$0")"
mkdir -p data/{hdr,clips,sci}
ln -sf "$data"/hdr/*.hdr data/hdr/
ln -sf "$data"/video/*.mp4 "$data"/sci/*.mat data/clips/
ln -sf "$data"/sci/*.mat data/sci/
[ -d data/photos ] || [ $# -gt 0 ] || python ../data/fetch.py data/photos
nscc sweep experiment.toml --out "$out" "$@"
