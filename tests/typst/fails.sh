#!/bin/sh
# A typst that finds a fault in the template, with an escape sequence in its message.
printf 'report.typ:12:7: error: unknown variable: contnets \033[31m\n' >&2
printf 'error: second line\n' >&2
exit 1
