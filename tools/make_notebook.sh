#!/usr/bin/env bash
# Runs docs/python/notebook.ipynb and writes the page docs/python/notebook.html.
#
#   tools/make_notebook.sh [BUILD]     BUILD: build/release
#
# Takes the Debian packages jupyter-nbconvert and python3-ipykernel.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${1:-build/release}
cd "$root"
page=$(mktemp -d)
trap 'rm -rf "$page"' EXIT
mkdir -p "$page/kernels/planish"
# It runs where it lies.
ln -s "$root/examples" "$page/examples"
cp docs/python/notebook.ipynb "$page"
cat > "$page/kernels/planish/kernel.json" <<JSON
{"argv": ["/usr/bin/python3", "-m", "ipykernel_launcher", "-f", "{connection_file}"],
 "display_name": "Planish", "language": "python", "env": {"PYTHONPATH": "$root/$build/python"}}
JSON
# Pictures as they are: the template of its own strips all drawing from SVG.
mkdir -p "$page/templates/planish"
echo '{"base_template": "basic"}' > "$page/templates/planish/conf.json"
cat > "$page/templates/planish/index.html.j2" <<'JINJA'
{%- extends 'basic/index.html.j2' -%}
{%- block data_svg scoped -%}<div class="output_svg">{{ output.data['image/svg+xml'] }}</div>{%- endblock data_svg -%}
JINJA
JUPYTER_PATH=$page PYDEVD_DISABLE_FILE_VALIDATION=1 /usr/bin/jupyter-nbconvert --log-level=WARN --execute --to html --template planish --TemplateExporter.extra_template_basedirs="$page/templates" \
  --ExecutePreprocessor.kernel_name=planish --stdout "$page/notebook.ipynb" > "$page/body.html"
{
  cat <<'HTML'
<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>Planish in a notebook</title>
<style>
  body { font: 16px/1.5 system-ui, sans-serif; max-width: 900px; margin: 2em auto; padding: 0 1em; color: #1b1f23; }
  pre { font-size: 14px; padding: .6em .8em; overflow-x: auto; margin: .4em 0; }
  .output pre { white-space: pre-wrap; }
  .jp-InputArea pre, .input pre { background: #f3f5f7; border-left: 3px solid #1d5fc4; }
  .prompt, .jp-InputPrompt, .jp-OutputPrompt, .anchor-link { display: none; }
  svg { max-width: 100%; height: auto; max-height: 460px; }
  .k, .kn, .ow { color: #7b2fa8; } .s, .s1, .s2, .sa, .si { color: #22702f; } .mi, .mf { color: #a3551a; } .nb { color: #1d5fc4; }
</style>
HTML
  cat "$page/body.html"
  echo "</html>"
} > docs/python/notebook.html
