-- The kernels once more, statement for statement as far as Lua has the statement: its loops test and
-- count as those of the motion program do. Ints wrap to 32 bits where the motion program's can
-- overflow; fixed-point products are shifted like there. The functions named ..._for do the same
-- with Lua's numeric for, which counts by itself.

local function wrap(x) return ((x + 0x80000000) & 0xffffffff) - 0x80000000 end

local function sum(first, last)
  local total = 0
  local i = first
  while i <= last do
    total = total + i
    i = i + 1
  end
  return wrap(total)
end

local function multiply_accumulate(n)
  local x, y, acc = 69632, 64512, 0
  local i = 1
  while i <= n do
    local product = (x * y) >> 16
    acc = acc + product
    i = i + 1
  end
  return acc
end

local function prefix_sum(n)
  local a = {}
  local i = 0
  while i < 1000 do
    a[i] = 1
    i = i + 1
  end
  local s
  while n ~= 0 do
    s = 0
    i = 0
    while i < 1000 do
      s = s + a[i]
      a[i] = s
      i = i + 1
    end
    n = n - 1
  end
  return wrap(s)
end

local function collatz(n)
  local steps = 0
  local i = 1
  while i <= n do
    local x = i
    while x ~= 1 do
      steps = steps + 1
      if x % 2 ~= 0 then
        x = x * 3
        x = x + 1
      else
        x = x // 2
      end
    end
    i = i + 1
  end
  return steps
end

local function sum_for(first, last)
  local total = 0
  for i = first, last do
    total = total + i
  end
  return wrap(total)
end

local function multiply_accumulate_for(n)
  local x, y, acc = 69632, 64512, 0
  for _ = 1, n do
    local product = (x * y) >> 16
    acc = acc + product
  end
  return acc
end

local function prefix_sum_for(n)
  local a = {}
  for i = 0, 999 do
    a[i] = 1
  end
  local s
  for _ = 1, n do
    s = 0
    for i = 0, 999 do
      s = s + a[i]
      a[i] = s
    end
  end
  return wrap(s)
end

local function collatz_for(n)
  local steps = 0
  for i = 1, n do
    local x = i
    while x ~= 1 do
      steps = steps + 1
      if x % 2 ~= 0 then
        x = x * 3
        x = x + 1
      else
        x = x // 2
      end
    end
  end
  return steps
end

return {
  sum = function(n) return sum(1, n) end,
  sum_for = function(n) return sum_for(1, n) end,
  multiply_accumulate = multiply_accumulate,
  multiply_accumulate_for = multiply_accumulate_for,
  prefix_sum = prefix_sum,
  prefix_sum_for = prefix_sum_for,
  collatz = collatz,
  collatz_for = collatz_for,
}
