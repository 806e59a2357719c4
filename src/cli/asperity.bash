# Completion of the command `asperity` for bash, by what the command itself says may follow.
# SPDX-License-Identifier: GPL-3.0-or-later

_asperity() {
  local line=${COMP_LINE:0:COMP_POINT} words offers
  local word=${line##*[[:blank:]]}
  read -ra words <<< "${line%"$word"}"
  offers=$("${words[0]}" help --words "${words[@]:1}" 2> /dev/null)
  mapfile -t COMPREPLY < <(compgen -W "${offers/FILE/}" -- "$word")
  [[ $offers != *FILE* ]] || mapfile -t -O ${#COMPREPLY[@]} COMPREPLY < <(compgen -f -- "$word")
}
complete -o filenames -F _asperity asperity
