#!/usr/bin/env bash
# build.sh: makes view.bundle.js anew from the sources here; equal sources give equal bytes. Needs node and npm.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")"
npm ci --ignore-scripts --no-audit --no-fund
node_modules/.bin/esbuild view.js --bundle --minify --charset=ascii --format=iife --target=es2021 \
  --legal-comments=none --banner:js="$(cat notices.txt)" --outfile=view.bundle.js
