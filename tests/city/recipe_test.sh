#!/usr/bin/env bash
# recipe_test.sh EDGESHADE MAKE_CITY ASSETS: the recipe for Snakemake, whose jobs are killed, gives the
# same bytes as one job; without Snakemake the recipe's commands are run until they succeed.
set -euo pipefail
edgeshade=$1 make_city=$2 assets=$3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
"$make_city" tiles gltf 3 2 2 20 1 >/dev/null
options=(--place 48.14,11.57 --date 2026-03-21 --step 60 --grid 2)
"$edgeshade" city plan tiles "${options[@]}" -o whole.json
"$edgeshade" city run whole.json --job 1
"$edgeshade" city merge whole.json -o whole
"$edgeshade" city plan tiles "${options[@]}" --tiles 4 -o plan.json

# A program whose every second job is killed, once, after a while of its own.
cat >killed.sh <<KILLED
#!/usr/bin/env bash
if [[ \$2 == run && ! -e killed-\$5 && \$((\$5 % 2)) == 0 ]]; then
    touch killed-\$5
    "$edgeshade" "\$@" & sleep 0.0\$((RANDOM % 10)); kill -9 \$! ; wait \$!
else
    exec "$edgeshade" "\$@"
fi
KILLED
chmod +x killed.sh

for try in 1 2 3; do
    if command -v snakemake >/dev/null; then
        snakemake --quiet all --cores 2 --keep-going --rerun-incomplete \
            --snakefile "$assets/recipes/city.smk" \
            --config edgeshade="$folder/killed.sh" plan=plan.json map=map && break
    else
        for job in 1 2 3 4; do
            [[ -e plan.json.jobs/job-$job.city ]] || ./killed.sh city run plan.json --job $job || true
        done
        ./killed.sh city merge plan.json -o map && break
    fi
    echo "try $try ended early"
done
ls killed-*
cmp whole/hours.tif map/hours.tif
cmp whole/objects.csv map/objects.csv
cmp whole/preview.png map/preview.png

# A task of Slurm's array does the same job.
cp plan.json.jobs/job-3.city job-3.city
SLURM_ARRAY_TASK_ID=3 PATH=$(dirname "$edgeshade"):$PATH bash "$assets/recipes/city.slurm" plan.json
cmp job-3.city plan.json.jobs/job-3.city
