-- The held-out kernels, statement for statement as far as Lua has the statement, like kernels.lua.

local function wrap(x) return ((x + 0x80000000) & 0xffffffff) - 0x80000000 end

local function gcd(n)
  local total = 0
  local i = 1
  while i <= n do
    local a = n
    local b = i
    while b ~= 0 do
      local rest = a % b
      a = b
      b = rest
    end
    total = total + a
    i = i + 1
  end
  return total
end

local function gcd_for(n)
  local total = 0
  for i = 1, n do
    local a = n
    local b = i
    while b ~= 0 do
      local rest = a % b
      a = b
      b = rest
    end
    total = total + a
  end
  return total
end

local function sieve(n)
  local prime = {}
  local count
  while n ~= 0 do
    local i = 2
    while i < 1000 do
      prime[i] = 1
      i = i + 1
    end
    count = 0
    i = 2
    while i < 1000 do
      if prime[i] ~= 0 then
        count = count + 1
        local multiple = i + i
        while multiple < 1000 do
          prime[multiple] = 0
          multiple = multiple + i
        end
      end
      i = i + 1
    end
    n = n - 1
  end
  return count
end

local function sieve_for(n)
  local prime = {}
  local count
  for _ = 1, n do
    for i = 2, 999 do
      prime[i] = 1
    end
    count = 0
    for i = 2, 999 do
      if prime[i] ~= 0 then
        count = count + 1
        for multiple = i + i, 999, i do
          prime[multiple] = 0
        end
      end
    end
  end
  return count
end

-- Positive, so that the upper half takes no mask.
local function hash_mix(n)
  local x = 12345
  local hash = 0
  while n ~= 0 do
    x = x * 1664525
    x = (x + 1013904223) & 0xffffffff
    local upper = x >> 16
    hash = hash ~ upper
    hash = (hash * 31) & 0xffffffff
    n = n - 1
  end
  return wrap(hash)
end

local function hash_mix_for(n)
  local x = 12345
  local hash = 0
  for _ = 1, n do
    x = x * 1664525
    x = (x + 1013904223) & 0xffffffff
    local upper = x >> 16
    hash = hash ~ upper
    hash = (hash * 31) & 0xffffffff
  end
  return wrap(hash)
end

-- The literals times 65536. Nothing is negative, so that a shift truncates.
local function biquad(n)
  local x, x1, x2, y1, y2 = 16384, 0, 0, 0, 0
  local total = 0
  local phase = 0
  local i = 0
  while i < n do
    phase = phase + 1
    if phase >= 100 then
      phase = 0
      x = 81920 - x
    end
    local y = (655 * x) >> 16
    local part = (1311 * x1) >> 16
    y = y + part
    part = (655 * x2) >> 16
    y = y + part
    part = (104858 * y1) >> 16
    y = y + part
    part = (41943 * y2) >> 16
    y = y - part
    x2 = x1
    x1 = x
    y2 = y1
    y1 = y
    total = total + y
    i = i + 1
  end
  return total
end

local function biquad_for(n)
  local x, x1, x2, y1, y2 = 16384, 0, 0, 0, 0
  local total = 0
  local phase = 0
  for _ = 1, n do
    phase = phase + 1
    if phase >= 100 then
      phase = 0
      x = 81920 - x
    end
    local y = (655 * x) >> 16
    local part = (1311 * x1) >> 16
    y = y + part
    part = (655 * x2) >> 16
    y = y + part
    part = (104858 * y1) >> 16
    y = y + part
    part = (41943 * y2) >> 16
    y = y - part
    x2 = x1
    x1 = x
    y2 = y1
    y1 = y
    total = total + y
  end
  return total
end

local function bubble_sort(n)
  local a = {}
  local x = 1
  local total = 0
  while n ~= 0 do
    local i = 0
    while i < 200 do
      x = x * 75
      x = x + 74
      x = x % 65537
      a[i] = x
      i = i + 1
    end
    local last = 199
    while last ~= 0 do
      i = 0
      while i < last do
        local next = i + 1
        if a[i] > a[next] then
          local kept = a[i]
          a[i] = a[next]
          a[next] = kept
        end
        i = next
      end
      last = last - 1
    end
    total = total + a[100]
    n = n - 1
  end
  return wrap(total)
end

local function bubble_sort_for(n)
  local a = {}
  local x = 1
  local total = 0
  for _ = 1, n do
    for i = 0, 199 do
      x = x * 75
      x = x + 74
      x = x % 65537
      a[i] = x
    end
    for last = 199, 1, -1 do
      for i = 0, last - 1 do
        local next = i + 1
        if a[i] > a[next] then
          local kept = a[i]
          a[i] = a[next]
          a[next] = kept
        end
      end
    end
    total = total + a[100]
  end
  return wrap(total)
end

local function plc(n)
  local state = 0
  local timer = 0
  local bottles = 0
  local stops = 0
  local cycle = 0
  while cycle < n do
    local inputs = cycle >> 3
    inputs = inputs ~ cycle
    local bottle = inputs & 1
    local full = inputs & 6
    local overflow = inputs & 56
    if state == 0 then
      if bottle ~= 0 then
        state = 1
        timer = 20
      end
    elseif state == 1 then
      timer = timer - 1
      if overflow == 56 then
        stops = stops + 1
        state = 4
      elseif full == 6 or timer == 0 then
        state = 2
        timer = 3
      end
    elseif state == 2 then
      timer = timer - 1
      if timer == 0 then
        state = 3
        timer = 5
      end
    elseif state == 3 then
      timer = timer - 1
      if timer == 0 then
        bottles = bottles + 1
        state = 0
      end
    else
      state = 0
      if overflow == 56 then
        stops = stops + 1
        state = 4
      end
    end
    cycle = cycle + 1
  end
  return wrap(bottles + stops * 1000)
end

local function plc_for(n)
  local state = 0
  local timer = 0
  local bottles = 0
  local stops = 0
  for cycle = 0, n - 1 do
    local inputs = cycle >> 3
    inputs = inputs ~ cycle
    local bottle = inputs & 1
    local full = inputs & 6
    local overflow = inputs & 56
    if state == 0 then
      if bottle ~= 0 then
        state = 1
        timer = 20
      end
    elseif state == 1 then
      timer = timer - 1
      if overflow == 56 then
        stops = stops + 1
        state = 4
      elseif full == 6 or timer == 0 then
        state = 2
        timer = 3
      end
    elseif state == 2 then
      timer = timer - 1
      if timer == 0 then
        state = 3
        timer = 5
      end
    elseif state == 3 then
      timer = timer - 1
      if timer == 0 then
        bottles = bottles + 1
        state = 0
      end
    else
      state = 0
      if overflow == 56 then
        stops = stops + 1
        state = 4
      end
    end
  end
  return wrap(bottles + stops * 1000)
end

return {
  gcd = gcd,
  gcd_for = gcd_for,
  sieve = sieve,
  sieve_for = sieve_for,
  hash_mix = hash_mix,
  hash_mix_for = hash_mix_for,
  biquad = biquad,
  biquad_for = biquad_for,
  bubble_sort = bubble_sort,
  bubble_sort_for = bubble_sort_for,
  plc = plc,
  plc_for = plc_for,
}
