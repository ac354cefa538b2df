#!/bin/bash
# Trains and evaluates everything in this folder again, on two cores in about three hours:
#   bash training/results/reproduce.sh DATA OUT
# DATA holds hdr/*.hdr (24 panoramas, 512 x 1024), video/*.mp4 and sci/*.mat. OUT is made: links to
# the data as they are split, run folders, results of `nscc evaluate`, comparisons.
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
data=$(cd "$1" && pwd)
mkdir -p "$2" && cd "$2"
mkdir -p data/{hdr_train,hdr_test,pano,mixed,clips,sci} runs results

# Of five panoramas by name the second and the fourth are kept back.
k=0
for file in "$data"/hdr/*.hdr; do
    part=hdr_train
    case $((k % 5)) in 1 | 3) part=hdr_test ;; esac
    ln -sf "$file" "data/$part/"
    k=$((k + 1))
done
ln -sf "$data"/hdr/*.hdr data/pano/
ln -sf "$data"/hdr/*.hdr "$data"/video/*.mp4 data/mixed/
ln -sf "$data"/video/*.mp4 "$data"/sci/*.mat data/clips/
ln -sf "$data"/sci/*.mat data/sci/
cp "$here"/*.toml .

# NAME PROTOCOL DATA CONFIG [--set K=V ...]: a run, and its result.
learn() {
    local name=$1 protocol=$2 scenes=$3 config=$4
    shift 4
    nscc train "$config" --out "runs/$name" "$@"
    nscc evaluate "runs/$name" --data "$scenes" --protocol "$protocol" -o "results/$name.json"
}

# NAME PROTOCOL DATA: a baseline's result.
baseline() {
    nscc evaluate "$1" --data "$3" --protocol "$2" -o "results/$1.json"
}

