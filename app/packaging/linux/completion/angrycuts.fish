# fish completion for angrycuts
set -l commands scenes simulate measure
set -l none "not __fish_seen_subcommand_from $commands"
set -l runs "__fish_seen_subcommand_from simulate measure"
set -l simulate "__fish_seen_subcommand_from simulate"

complete -c angrycuts -f
complete -c angrycuts -l help -d "Every call and option"
complete -c angrycuts -n $none -l version -d "The version"
complete -c angrycuts -n $none -a scenes -d "List the built-in scenes"
complete -c angrycuts -n $none -a simulate -d "Run without a window"
complete -c angrycuts -n $none -a measure -d "Measure speed against accuracy"
complete -c angrycuts -n "not __fish_seen_subcommand_from scenes" \
    -a "(angrycuts scenes 2>/dev/null; __fish_complete_suffix .json)"

complete -c angrycuts -n "__fish_seen_subcommand_from scenes" -l export -x \
    -a "(__fish_complete_directories)" -d "Write them as files"

complete -c angrycuts -n $runs -l until -x -d "Simulated time to reach [s]"
complete -c angrycuts -n $runs -l cut -x -a never -d "When all ropes are cut [s]"
complete -c angrycuts -n $runs -l chart -r -F -d "Chart as .png, .svg or .pdf"
complete -c angrycuts -n "__fish_seen_subcommand_from measure" -l csv -r -F -d "All figures"

complete -c angrycuts -n $simulate -l method -x -a "euler semi-implicit-euler rk4 dopri5" \
    -d "Numerical method"
complete -c angrycuts -n $simulate -l step -x -d "Step of the method [s]"
complete -c angrycuts -n $simulate -l tolerance -x -d "Of dopri5, instead of a step"
complete -c angrycuts -n $simulate -l sample -x -d "Time between rows [s]"
complete -c angrycuts -n $simulate -l trajectory -r -F -d "Where every weight is"
complete -c angrycuts -n $simulate -l energy -r -F -d "Where the energy is"
complete -c angrycuts -n $simulate -l events -r -F -d "What happened"
