# bash completion for angrycuts                            -*- shell-script -*-

# Offers the words among its arguments that begin like $cur.
_angrycuts_words() { mapfile -t COMPREPLY < <(compgen -W "$*" -- "$cur"); }

# Offers folders, and files with one of the endings among its arguments.
_angrycuts_files() {
  local ending
  compopt -o filenames 2>/dev/null
  mapfile -t COMPREPLY < <({
    compgen -d -- "$cur"
    for ending in "$@"; do compgen -f -X "!*$ending" -- "$cur"; done
  } | sort -u)
}

# Offers the words among its arguments, built-in scenes, and scene files.
_angrycuts_scenes() {
  local -a files
  _angrycuts_files .json
  files=("${COMPREPLY[@]}")
  _angrycuts_words "$* $("$program" scenes 2>/dev/null | cut -f 1)"
  COMPREPLY+=("${files[@]}")
}

# What an option takes; fails for one that takes nothing.
_angrycuts_value() {
  case $1 in
    --method) _angrycuts_words euler semi-implicit-euler rk4 dopri5 ;;
    --cut) _angrycuts_words never ;;
    --step | --tolerance | --until | --sample) ;;
    --trajectory | --energy | --events | --csv) _angrycuts_files '' ;;
    --chart) _angrycuts_files .png .svg .pdf ;;
    --export) _angrycuts_files ;;
    *) return 1 ;;
  esac
}

_angrycuts_options() {
  case $1 in
    simulate)
      _angrycuts_words --method --step --tolerance --until --cut --sample --trajectory --energy \
        --events --chart --help
      ;;
    measure) _angrycuts_words --until --cut --csv --chart --help ;;
    scenes) _angrycuts_words --export --help ;;
    *) _angrycuts_words --help --version ;;
  esac
}

_angrycuts() {
  local program=$1 cur=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command=
  # --method=rk4 comes as three words.
  if [[ $cur == = ]]; then
    cur=
  elif [[ $before == = ]]; then
    before=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  if [ "$COMP_CWORD" -gt 1 ]; then command=${COMP_WORDS[1]}; fi
  COMPREPLY=()
  if _angrycuts_value "$before"; then return; fi
  case $command,$cur in
    *,-*) _angrycuts_options "$command" ;;
    ,*) _angrycuts_scenes scenes simulate measure ;;
    simulate,* | measure,*) _angrycuts_scenes ;;
  esac
}
complete -F _angrycuts angrycuts
