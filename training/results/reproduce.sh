#!/bin/bash
# Trains and evaluates everything in this folder again, on two cores in about five hours:
#   bash training/results/reproduce.sh DATA OUT
# DATA holds hdr/*.hdr (24 panoramas, 512 x 1024), video/*.mp4 and sci/*.mat. OUT is made: links to
# the data as they are split, run folders, results of `nscc evaluate`, comparisons.
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
data=$(cd "$1" && pwd)
mkdir -p "$2" && cd "$2"
mkdir -p data/{hdr_train,hdr_test,pano,mixed,clips,sci} runs results/linear

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

# NAME PROTOCOL DATA CONFIG [--set K=V ...]: a run, and its result, in the folder $into: tables take
# all results of a row for its seeds.
into=results
learn() {
    local name=$1 protocol=$2 scenes=$3 config=$4
    shift 4
    nscc train "$config" --out "runs/$name" "$@"
    nscc evaluate "runs/$name" --data "$scenes" --protocol "$protocol" -o "$into/$name.json"
}

# NAME PROTOCOL DATA: a baseline's result.
baseline() {
    nscc evaluate "$1" --data "$3" --protocol "$2" -o "results/$1.json"
}

for name in ldr best-uniform best-uniform-mu quad random sparse-coding; do
    baseline "$name" hdr-v1 data/hdr_test
done
for seed in 0 1 2; do
    set_seed=(--set train.seed=$seed)
    fixed=(--set shutter.learn=false)
    learn hdr_learned_$seed hdr-v1 data/hdr_test hdr.toml "${set_seed[@]}"
    learn hdr_quad_$seed hdr-v1 data/hdr_test hdr.toml "${set_seed[@]}" "${fixed[@]}"
    learn hdr_random_$seed hdr-v1 data/hdr_test hdr.toml "${set_seed[@]}" "${fixed[@]}" \
        --set shutter.init=random
    into=results/linear
    linear=("${set_seed[@]}" --set loss.name=psnr --set shutter.settle=0.2)
    learn lin_learned_$seed hdr-v1 data/hdr_test hdr.toml "${linear[@]}"
    learn lin_quad_$seed hdr-v1 data/hdr_test hdr.toml "${linear[@]}" "${fixed[@]}"
    learn lin_random_$seed hdr-v1 data/hdr_test hdr.toml "${linear[@]}" "${fixed[@]}" \
        --set shutter.init=random
    into=results
    learn vid_learned_$seed video-v1 data/clips clip.toml "${set_seed[@]}"
    learn vid_quad_$seed video-v1 data/clips clip.toml "${set_seed[@]}" "${fixed[@]}"
    learn vid_random_$seed video-v1 data/clips clip.toml "${set_seed[@]}" "${fixed[@]}" \
        --set shutter.init=random
done

for name in bilinear thin-out dictionary gap-tv; do
    baseline "$name" video-v1 data/clips
done
kept=(--set shutter.learn=false)
# Digits are many, and each says little.
bits=(--set shutter.noise=0.35 --set shutter.tried_share=1.0 --set shutter.settle=0.4
    --set train.code_rate=1e-2)
wide=(--set shutter.class=e --set shutter.target=scamp7)
clip() {
    local name=$1
    shift
    learn "$name" video-v1 data/clips clip.toml "${rows[@]}" "$@"
}
rows=(--set decoder.name=fcnet --set train.steps=3000 --set train.validate_every=1000)
clip fc_c_quad --set shutter.class=c "${kept[@]}"
clip fc_c_learned --set shutter.class=c
clip fc_d_quad "${kept[@]}"
clip fc_d_learned
clip fc_e_random "${wide[@]}" "${kept[@]}" --set shutter.init=random
clip fc_e_learned "${wide[@]}" "${bits[@]}"
rows=(--set decoder.name=unet3d --set train.steps=600 --set train.batch=2 --set data.together=2
    --set train.dtype=bf16 --set train.validate_every=300)
clip u3_codebook_learned --set shutter.class=codebook "${bits[@]}"
clip u3_codebook_words --set shutter.class=codebook "${bits[@]}" --set shutter.words_weight=0.05
clip u3_c_quad --set shutter.class=c "${kept[@]}"
clip u3_c_learned --set shutter.class=c
clip u3_e_random "${wide[@]}" "${kept[@]}" --set shutter.init=random
clip u3_e_learned "${wide[@]}" "${bits[@]}"
for seed in 0 1 2; do
    rows=(--set decoder.name=unet3d --set train.steps=2500 --set train.dtype=bf16
        --set train.seed=$seed)
    clip u3_d_learned_$seed
    clip u3_d_quad_$seed "${kept[@]}"
    clip u3_d_random_$seed "${kept[@]}" --set shutter.init=random
done
rows=("${kept[@]}")
for width in 0.5 0.25; do
    clip vid_quad_w${width/./} --set decoder.width=$width
done

# What accuracy costs in time: the 2 x 2 pattern's decoders on the same captures.
nscc tradeoff decoder --data data/clips --scenes 7 --size 256 --budget 90 --run runs/vid_quad_0 --run runs/vid_quad_w05 \
    --run runs/vid_quad_w025 --run runs/fc_d_quad --run runs/u3_c_quad -o results/decoders

learn sci8 sci8 data/sci sci8.toml
nscc evaluate sci8 data/sci/*.mat --method gap-tv -o results/gap-tv-sci8.json

# FIRST SECOND METRIC: how much better the second is, over all seeds, whose number @ stands for.
over() {
    local pairs=()
    for seed in 0 1 2; do
        pairs+=("$into/${1/@/$seed}.json" "$into/${2/@/$seed}.json")
    done
    nscc evaluate compare "${pairs[@]}" --metric "$3"
}
for other in random quad; do
    over hdr_${other}_@ hdr_learned_@ mu_psnr_db
    over hdr_${other}_@ hdr_learned_@ psnr_db
    into=results/linear over lin_${other}_@ lin_learned_@ psnr_db
    over vid_${other}_@ vid_learned_@ psnr_db
    over u3_d_${other}_@ u3_d_learned_@ psnr_db
done
over best-uniform-mu hdr_learned_@ mu_psnr_db
over bilinear vid_learned_@ psnr_db
over bilinear u3_d_learned_@ psnr_db

# What moving single edges would cost the pattern's decoder, and the pictures.
python "$here"/moves.py runs/vid_quad_0
show=shown
still() { nscc evaluate "$1" --data data/hdr_test --protocol hdr-v1 --save "$show/$2" >/dev/null; }
film() { nscc evaluate "$1" --data data/clips --protocol video-v1 --save "$show/$2" >/dev/null; }
for name in ldr best-uniform-mu; do still $name $name; done
for name in hdr_quad_0 hdr_learned_0; do still runs/$name $name; done
film bilinear bilinear
for name in vid_random_0 vid_quad_0 vid_learned_0; do film runs/$name $name; done
python "$here"/figure.py hdr.png vestibule_1k_128_0 studio_small_05_1k_128_0 -- \
    "always open=$show/ldr" "best uniform=$show/best-uniform-mu" "2 x 2=$show/hdr_quad_0" "learned=$show/hdr_learned_0"
python "$here"/figure.py clips.png cvvdp_ferris_0 runner_0 -- "bilinear=$show/bilinear" \
    "random=$show/vid_random_0" "2 x 2=$show/vid_quad_0" "learned=$show/vid_learned_0"

mkdir -p tables/hdr tables/video
ln -sf "$PWD"/data/hdr_test/* tables/hdr/
ln -sf "$PWD"/data/clips/* tables/video/
nscc evaluate tables --data tables --runs runs --results results
