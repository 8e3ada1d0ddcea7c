-- SPDX-License-Identifier: MIT
-- Figures in documents of Pandoc, in HTML and in LaTeX: pandoc --lua-filter rastertrace.lua page.md -o page.html
--
--     ```rastertrace
--     scene.json --step "scanline y=2"
--     ```
--
-- A block holds what would be typed after `rastertrace figure`; or such options, and then a scene itself.
-- LaTeX needs \usepackage{tikz} (-V header-includes='\usepackage{tikz}').
local program = os.getenv("RASTERTRACE") or "rastertrace"

-- Words; one with blanks stands in quotes.
local function add_words(text, words)
  local at = 1
  while text:find("%S", at) do
    local begin = text:find("%S", at)
    local quote = text:sub(begin, begin)
    local is_quoted = quote == '"' or quote == "'"
    local stop = text:find(is_quoted and quote or "%s", begin + 1) or #text + 1
    words[#words + 1] = text:sub(begin + (is_quoted and 1 or 0), stop - 1)
    at = stop + 1
  end
end

function CodeBlock(block)
  if not block.classes:includes("rastertrace") then return nil end
  local form = FORMAT:match("latex") and "tex" or "svg"
  local begin = block.text:find("{", 1, true)
  local line, scene = block.text:sub(1, (begin or 0) - 1), begin and block.text:sub(begin) or ""
  local words = begin and {"-"} or {}
  add_words(line, words)
  for _, word in ipairs({"--format", form, "-o", "-"}) do words[#words + 1] = word end
  local drawn = pandoc.pipe(program, {"figure", table.unpack(words)}, scene)
  return pandoc.RawBlock(form == "tex" and "latex" or "html", drawn)
end
