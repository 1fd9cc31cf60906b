# Put a counter before every floating-point operation in x86-64 assembly (AT&T syntax, of gcc or
# clang).  Operation k of FLOP_.. (staged.h) increments bench_flops[k]; flags stay as they are.

function count(k, n)
{
  printf "\tmovq\t%%rax, bench_register(%%rip)\n"
  printf "\tmovq\tbench_flops+%d(%%rip), %%rax\n", 8*k
  printf "\tleaq\t%d(%%rax), %%rax\n", n
  printf "\tmovq\t%%rax, bench_flops+%d(%%rip)\n", 8*k
  printf "\tmovq\tbench_register(%%rip), %%rax\n"
}

{ n = $1 ~ /pd$/ ? 2 : 1 }
$1 ~ /^(add|sub)[sp]d$/ { count(0, n) }
$1 ~ /^mul[sp]d$/       { count(1, n) }
$1 ~ /^div[sp]d$/       { count(2, n) }
$1 ~ /^sqrt[sp]d$/      { count(3, n) }
$1 == "call" && $2 ~ /^sqrt(@PLT)?$/      { count(3, 1) }
$1 == "call" && $2 ~ /^(sin|cos)(@PLT)?$/ { count(4, 1) }
$1 == "call" && $2 ~ /^sincos(@PLT)?$/    { count(4, 2) }
{ print }
