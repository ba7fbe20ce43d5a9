# viewer.c of viewer.js, viewer.css and their hashes (viewer.sha256, a line each), as page_impl.h declares them.
#   cmake -D folder=FOLDER -P embed.cmake
set(text "/* Made by base/page/embed.cmake. */\n#include <stddef.h>\n")
file(STRINGS "${folder}/viewer.sha256" hashes)
foreach(kind js css)
  file(READ "${folder}/viewer.${kind}" bytes HEX)
  set(hash "")
  if(hashes)
    list(POP_FRONT hashes hash)
    set(hash "sha256-${hash}")
  endif()
  string(LENGTH "${bytes}" length)
  math(EXPR length "${length} / 2")
  string(REGEX REPLACE "(................................)" "\\1\n" bytes "${bytes}")
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
  string(APPEND text
    "extern const unsigned char um_page_viewer_${kind}[];\nextern const size_t um_page_viewer_${kind}_length;\n"
    "extern const char um_page_viewer_${kind}_hash[];\n"
    "const unsigned char um_page_viewer_${kind}[] = {${bytes}0};\n"
    "const size_t um_page_viewer_${kind}_length = ${length};\n"
    "const char um_page_viewer_${kind}_hash[] = \"${hash}\";\n")
endforeach()
file(WRITE "${folder}/viewer.c" "${text}")
