# Completion of the command `asperity` for bash: commands, options, materials, models and files, as the
# command itself tells them.
# SPDX-License-Identifier: GPL-3.0-or-later

_asperity() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command=${COMP_WORDS[1]}
  local program=${COMP_WORDS[0]} words kind
  COMPREPLY=()
  if [ "$COMP_CWORD" -eq 1 ] || { [ "$COMP_CWORD" -eq 2 ] && [ "$command" = help ]; }; then
    words=$("$program" --help 2> /dev/null | sed -n '/^Commands:/,/^$/s/^  \([a-z]*\) .*/\1/p')
    [ "$command" = help ] && words="$words wall"
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
    return
  fi
  words=$("$program" "$command" --help 2> /dev/null | sed -n 's/^  \(--[a-z_-]*\( [^ ][^ ]*\)\?\).*/\1/p')
  case $word in
    --*) mapfile -t COMPREPLY < <(compgen -W "$(cut -d ' ' -f 1 <<< "$words")" -- "$word"); return ;;
  esac
  case $before in -o) before=--output ;; esac
  kind=$(sed -n "s/^$before //p" <<< "$words")
  case $before,$kind in
    --*,*\|*) words=${kind//|/ } ;;
    *,*FILE* | profile,* | map,* | file,* | table,*)
      mapfile -t COMPREPLY < <(compgen -f -- "$word"); return ;;
    --*,?*) return ;;
    *) # a word of the wall's description: its table, choices and all, and the materials
      words=$({ "$program" help wall | grep -o '\b[a-z][a-z0-9_-]*\b'; "$program" materials | sed '1,2d; s/,.*//'; } 2> /dev/null | sort -u) ;;
  esac
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
}
complete -o filenames -F _asperity asperity
