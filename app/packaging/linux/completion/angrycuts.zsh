#compdef angrycuts

_angrycuts_scenes() {
  local -a names
  names=(${(f)"$($service scenes 2>/dev/null | cut -f 1)"})
  _alternative "scenes:built-in scene:($names)" 'files:scene file:_files -g "*.json"'
}

_angrycuts_first() {
  _alternative 'commands:command:(scenes simulate measure)' 'scenes: :_angrycuts_scenes'
}

_angrycuts() {
  local command=$words[2]
  local -a both
  both=(
    '--until[simulated time to reach]:seconds: '
    '--cut[when all ropes are cut]:seconds:(never)'
    '--chart[chart as a picture]:file:_files -g "*.(png|svg|pdf)"'
    '--help[every call and option]'
    ':scene:_angrycuts_scenes'
  )
  if ((CURRENT == 2)); then
    _arguments '--help[every call and option]' '--version[the version]' ':scene:_angrycuts_first'
    return
  fi
  # The command takes the program's place.
  shift words
  ((CURRENT--))
  case $command in
    simulate)
      _arguments $both \
        '--method[numerical method]:name:(euler semi-implicit-euler rk4 dopri5)' \
        '--step[step of the method]:seconds: ' \
        '--tolerance[of dopri5, instead of a step]:number: ' \
        '--sample[time between rows]:seconds: ' \
        '--trajectory[where every weight is]:file:_files' \
        '--energy[where the energy is]:file:_files' \
        '--events[what happened]:file:_files'
      ;;
    measure) _arguments $both '--csv[all figures]:file:_files' ;;
    scenes) _arguments '--export[write them as files]:folder:_files -/' '--help[every call and option]' ;;
  esac
}

_angrycuts "$@"
