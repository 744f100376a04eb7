# The demo: the desk without and with the Close Object Buffer, side by side, and a golden set of it that the float
# variant is held against. Run by the target `demo`:
#   cmake -DCOB=<program> -DSCENE=<desk.obj> -DOUTPUT=<folder> -P demo.cmake

function(run title)
  message(STATUS "${title}")
  string(REPLACE ";" " " shown "${ARGN}")
  message(STATUS "  ${shown}")
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_QUIET)
  set(result "${result}" PARENT_SCOPE)
endfunction()

function(must title)
  run("${title}" ${ARGN})
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "demo: this failed with ${result}")
  endif()
endfunction()

# Same patches, same light, same exposure; only the buffer differs.
set(same --shots 150 --exposure 0.35 --ambient --width 720 --picture-height 540)
must("The desk without the buffer" ${COB} render ${SCENE} -o ${OUTPUT}/none --refine none ${same})
must("The desk with the buffer" ${COB} render ${SCENE} -o ${OUTPUT}/buffer --refine buffer --buffer-edge 0.005 ${same}
     --beside ${OUTPUT}/none/picture.png)

must("A golden set of the desk" ${COB} golden ${SCENE} -o ${OUTPUT}/golden --edge 0.5 --segments 2000 --hard 400)
must("A float variant's answers to it" ${COB} answer ${OUTPUT}/golden --arithmetic float -o ${OUTPUT}/float)

message(STATUS "What of them is wrong")
execute_process(COMMAND ${COB} verify ${OUTPUT}/golden ${OUTPUT}/float --list 2 --json ${OUTPUT}/float.json
                RESULT_VARIABLE result OUTPUT_FILE ${OUTPUT}/float.txt)
file(READ ${OUTPUT}/float.txt report)
message("${report}")
if(NOT result EQUAL 1)
  message(FATAL_ERROR "demo: verify ended with ${result}, but float is wrong here, so 1 is due")
endif()

message(STATUS "")
message(STATUS "Look at")
message(STATUS "  ${OUTPUT}/buffer/beside.png    the desk without (left) and with (right) the buffer")
message(STATUS "  ${OUTPUT}/buffer/mesh.png      where the buffer refined")
message(STATUS "  ${OUTPUT}/buffer/states.png    elements by state: close, empty, occluded")
message(STATUS "  ${OUTPUT}/buffer/summary.txt   what it cost")
message(STATUS "  ${OUTPUT}/float.txt            what the float variant gets wrong in the golden set")
