#!/bin/sh
# A typst that is killed while it writes.
printf '%%PDF-1.7\n%%%%EOF\n' > report.pdf
kill -SEGV $$
