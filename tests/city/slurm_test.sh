#!/usr/bin/env bash
# slurm_test.sh EDGESHADE MAKE_CITY ASSETS: arrays of a real Slurm, whose jobs are killed, give the same bytes as one
# job without an engine. Skipped (77) where no Slurm answers; with_slurm.sh starts one.
set -euo pipefail
edgeshade=$1 make_city=$2 assets=$3
if ! command -v sbatch >/dev/null || ! timeout 5 sinfo --noheader >/dev/null 2>&1; then
    echo "Skipped: no Slurm answers to sinfo. tests/city/with_slurm.sh starts one for the command after it."
    exit 77
fi
folder=$(mktemp -d)
array=
trap '[[ -z $array ]] || scancel --quiet $array; rm -rf "$folder"' EXIT
cd "$folder"
"$make_city" tiles gltf 3 2 2 20 1 >/dev/null
options=(--place 48.14,11.57 --date 2026-03-21 --step 1 --grid 0.5)
"$edgeshade" city plan tiles "${options[@]}" -o whole.json
"$edgeshade" city run whole.json --job 1 2>/dev/null
"$edgeshade" city merge whole.json -o whole
"$edgeshade" city plan tiles "${options[@]}" --tiles 4 -o plan.json

# A program by the recipe's name. The first run of job 2 is killed; that of job 3 is killed with its batch script.
mkdir bin
cat >bin/edgeshade <<KILLED
#!/usr/bin/env bash
if [[ \$2 == run && \$5 == [23] ]] && mkdir killed-\$5; then
    "$edgeshade" "\$@" & sleep 0.05; kill -9 \$!; wait \$!
    cp -r plan.json.jobs left-\$5
    if [[ \$5 == 3 ]]; then kill -9 \$PPID; fi
    exit 137
fi
exec "$edgeshade" "\$@"
KILLED
chmod +x bin/edgeshade
export PATH=$folder/bin:$PATH
bytes=$(python3 -c 'import json; print(max(job["memory"] for job in json.load(open("plan.json"))["jobs"]))')
submit=(sbatch --parsable --cpus-per-task=1 --mem=$((bytes / 1000000))M --output=%a-%A.log)

# wait_for STATE TASK [SECONDS]: until the task of the last array is in that state.
wait_for() {
    local try
    for ((try = 0; try < 5 * ${3:-60}; ++try)); do
        [[ $(scontrol --oneliner show job "${array##* }_$2") != *JobState=$1* ]] || return 0
        sleep 0.2
    done
    echo "Task $2 is not $1:" >&2
    scontrol show job "${array##* }_$2" >&2
    cat ./*.log >&2
    return 1
}

mkdir plan.json.jobs
array=$("${submit[@]}" --array=1-2 "$assets/recipes/city.slurm" plan.json)
wait_for COMPLETED 1
# A task that is queued again waits until its credential has expired, for 2 minutes by default.
wait_for COMPLETED 2 240
array+=" $("${submit[@]}" --array=1-2 "$assets/recipes/city.slurm" plan.json 2)"
wait_for COMPLETED 2
wait_for FAILED 1
if "$edgeshade" city merge plan.json -o early 2>early.log; then exit 1; fi
grep "Job 3 of 4 has no result" early.log
[[ ! -e early ]]
scontrol requeue "${array##* }_1"
wait_for COMPLETED 1 240

for job in 2 3; do
    [[ -d killed-$job && ! -e left-$job/job-$job.city && -z $(compgen -G "left-$job/*part*") ]]
done
"$edgeshade" city merge plan.json -o map
for file in hours.tif objects.csv preview.png; do
    cmp whole/$file map/$file
done
