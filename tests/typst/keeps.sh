#!/bin/sh
# A typst that keeps what it is to set, in the folder that KEPT names, and leaves the least PDF.
for word; do main=$output; output=$word; done
mkdir -p "$KEPT/$main" && cp -R . "$KEPT/$main/" && printf '%%PDF-1.7\n%%%%EOF\n' > "$output"
