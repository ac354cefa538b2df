#!/bin/bash
# Trains and evaluates everything in this folder again, on two cores in about eight hours:
#   bash training/results/reproduce.sh DATA OUT [OPTION OF nscc sweep ...]
# DATA holds hdr/*.hdr (24 panoramas, 512 x 1024), video/*.mp4 and sci/*.mat. OUT is made: links to
# the data as they are split, photographs that training/data/fetch.py fetches, and five sweeps, of
# results.toml, linear.toml, wide.toml, successors.toml and ways.toml, with their runs and results.
# Ended and started again it goes on.
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
data=$(cd "$1" && pwd)
mkdir -p "$2" && cd "$2"
shift 2
mkdir -p data/{hdr_train,hdr_test,pano,mixed,clips,sci,scenes}

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
[ -d photos ] || python "$here"/../data/fetch.py photos
ln -sf "$data"/hdr/*.hdr "$PWD"/photos/*/*.jpg data/scenes/
ln -sfn scenes data/moving
cp "$here"/*.toml .

nscc sweep results.toml --out all "$@"
nscc sweep linear.toml --out linear "$@"
nscc sweep wide.toml --out wide "$@"
nscc sweep successors.toml --out successors "$@"
nscc sweep ways.toml --out ways "$@"
nscc evaluate looks --data data/hdr_test --results all

# Codes behind the decoder for any code: given, found by searches, and those that these began with;
# the last one found once more, behind the decoder that judged it, and after it has learned the code.
nscc train tuned.toml --out all/runs/tuned
codes=(quad=c:quad two-phase=c:two-phase staggered=c:staggered cyclic=e:cyclic
    random-c=c:random random-d=d:random found_words=all/runs/searched_words
    judge=all/runs/searched_2@own tuned=all/runs/tuned@own)
for seed in 0 1 2; do
    codes+=("start_$seed=all/runs/searched_$seed@start" "found_$seed=all/runs/searched_$seed")
done
for way in search tried straight straight_noise; do codes+=("way_$way=ways/runs/way_$way"); done
python "$here"/codes.py data/clips all/results "${codes[@]}"

# What comes with nscc: learned on under everything that the emulator does to frames.
mkdir -p all/results/under
score() { # RUN DATA PROTOCOL EFFECTS
    nscc evaluate "all/runs/$1" --data "data/$2" --protocol "$3" ${4:+--effects "$4"} \
        -o "all/results/under/$1${4:+-$4}.json"
}
for kind in still clip; do
    nscc train under_$kind.toml --out all/runs/under_$kind
done
nscc train under_clip.toml --set 'sensor.effects=""' --out all/runs/noise_clip
for effects in all ''; do
    score under_still hdr_test hdr-v1 "$effects"
    score under_clip clips video-v1 "$effects"
done
score noise_clip clips video-v1 ""
score hdr_learned_0 hdr_test hdr-v1 all
for name in vid_learned_0 u3_d_learned_1; do score $name clips video-v1 all; done
python "$here"/without.py all/results/under/without.json all/runs/under_still all/runs/under_clip

# What accuracy costs in time: the 2 x 2 pattern's decoders on the same captures.
nscc tradeoff decoder --data data/clips --scenes 7 --size 256 --budget 90 \
    --run all/runs/vid_quad_0 --run all/runs/vid_quad_w05 --run all/runs/vid_quad_w025 \
    --run all/runs/fc_d_quad --run all/runs/u3_c_quad -o all/decoders

# FOLDER FIRST SECOND METRIC: how much better the second is, over all seeds, whose number @ stands
# for.
over() {
    local pairs=()
    for seed in 0 1 2; do
        pairs+=("$1/results/${2/@/$seed}.json" "$1/results/${3/@/$seed}.json")
    done
    nscc evaluate compare "${pairs[@]}" --metric "$4"
}
for other in random quad; do
    over all hdr_${other}_@ hdr_learned_@ mu_psnr_db
    over all hdr_${other}_@ hdr_learned_@ psnr_db
    over linear lin_${other}_@ lin_learned_@ psnr_db
    over all vid_${other}_@ vid_learned_@ psnr_db
    over all u3_d_${other}_@ u3_d_learned_@ psnr_db
done
for metric in psnr_db mu_psnr_db; do over wide wide_quad_@ wide_learned_@ $metric; done
over all best-uniform-mu hdr_learned_@ mu_psnr_db
over all bilinear vid_learned_@ psnr_db
over all bilinear u3_d_learned_@ psnr_db

# What moving single edges would cost the pattern's decoder, and the pictures.
python "$here"/moves.py all/runs/vid_quad_0
show=shown
still() { nscc evaluate "$1" --data data/hdr_test --protocol hdr-v1 --save "$show/$2" >/dev/null; }
film() { nscc evaluate "$1" --data data/clips --protocol video-v1 --save "$show/$2" >/dev/null; }
for name in ldr best-uniform-mu; do still $name $name; done
for name in hdr_quad_0 hdr_learned_0; do still all/runs/$name $name; done
film bilinear bilinear
for name in vid_random_0 vid_quad_0 vid_learned_0; do film all/runs/$name $name; done
python "$here"/figure.py hdr.png vestibule_1k_128_0 studio_small_05_1k_128_0 -- \
    "always open=$show/ldr" "best uniform=$show/best-uniform-mu" "2 x 2=$show/hdr_quad_0" "learned=$show/hdr_learned_0"
python "$here"/figure.py clips.png cvvdp_ferris_0 runner_0 -- "bilinear=$show/bilinear" \
    "random=$show/vid_random_0" "2 x 2=$show/vid_quad_0" "learned=$show/vid_learned_0"

# Decoders of the paper's size, on one core: with `--minutes M` and again for shorter turns.
python "$here"/paper_size.py data all/paper
for name in random quad learned; do still all/paper/paper_hdr_$name paper_$name; done
python "$here"/figure.py paper.png vestibule_1k_128_0 studio_small_05_1k_128_0 -- \
    "small, learned=$show/hdr_learned_0" "random=$show/paper_random" "2 x 2=$show/paper_quad" "learned=$show/paper_learned"

mkdir -p tables/hdr tables/video
ln -sf "$PWD"/data/hdr_test/* tables/hdr/
ln -sf "$PWD"/data/clips/* tables/video/
nscc evaluate tables --data tables --runs all/runs --results all/results
nscc evaluate figures --data tables -o figures
