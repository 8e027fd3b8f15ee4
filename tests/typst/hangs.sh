#!/bin/sh
# A typst that never ends and holds its standard error open in a child of its own.
echo "report.typ:1:1: warning: still thinking" >&2
sleep 40 &
sleep 40
