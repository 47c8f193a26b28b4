import type { MessageCatalogue } from './translateMessage.ts';

/** Messages about user-written shader text; see index.ts for the format. */
export const shaderText: MessageCatalogue = {
  'line {}, column {}: {}': '第 {1} 行第 {2} 列：{3}',

  // The words of a text
  'the text has {} characters; more than {} are not taken: shorten it': '文本有 {1} 个字符，上限为 {2} 个：请缩短',
  'the character {} has no meaning in WGSL': '字符 {1} 在 WGSL 中没有意义',
  'this comment has no end: close it with */': '此注释没有结尾：请以 */ 结束',

  // Its structure
  'expected {} here, found {}': '此处应为{1}，而不是{2}',
  'the end of the text': '文本结尾',
  'a statement': '语句',
  'an expression': '表达式',
  'a parameter': '参数',
  'a name for the function': '函数的名称',
  'a name for the value': '值的名称',
  'the name of a type': '类型的名称',
  'x, y, z or w': ' x、y、z 或 w',
  '{} gives nothing: write `-> vec4f`, or what else it returns': '{1} 没有返回类型：请写 `-> vec4f` 或其他返回类型',
  'this returns nothing: write the value after `return`': '这里没有返回值：请在 `return` 之后写出值',
  '{} has no value: write `= …` after it': '{1} 没有值：请在其后写 `= …`',
  'what {} returns is not used: assign it, or leave the call out': '{1} 的返回值没有使用：请赋值给变量，或去掉此调用',
  'this lies more than {} brackets deep: give parts of it names': '括号嵌套超过 {1} 层：请为其中的部分另设名称',
  'this statement is longer than {} operators: give parts of it names':
    '此语句超过 {1} 个运算符：请为其中的部分另设名称',

  // Unsupported syntax, and what to write instead
  '`{}` is not taken: {}': '不支持 `{1}`：{2}',
  'write a `for` whose count is known: `for (var i = 0; i < 16; i++)`':
    '请写次数已知的 `for`：`for (var i = 0; i < 16; i++)`',
  'write `if … else if … else`': '请写 `if … else if … else`',
  'return the colour that is to be there': '请返回该处应有的颜色',
  'use vectors': '请用向量',
  "write the type's own name": '请写类型本来的名称',
  'use `const`, or arg1 … arg4 for what is to be turned': '请用 `const`；需要调节的值请用 arg1 … arg4',
  'what it enables is not taken': '不支持它启用的功能',
  'what it requires is not taken': '不支持它要求的功能',
  'leave it out': '请去掉',
  'the type {} is not taken: {}': '不支持类型 {1}：{2}',
  'pass and return values: numbers, vectors and matrices': '请传递和返回值：数、向量和矩阵',
  'pixels are read by image(offset), depth(offset), normal(offset) …':
    '像素用 image(offset)、depth(offset)、normal(offset) … 读取',
  'use i32': '请用 i32',
  'use f32': '请用 f32',
  '`var` outside of a function is not taken: declare it inside, or use `const`':
    '不支持函数之外的 `var`：请在函数内声明，或用 `const`',
  'address spaces are not taken: write `var` alone': '不支持地址空间：请只写 `var`',
  'attributes are not taken: leave them out': '不支持 @ 属性：请去掉',
  'pointers are not taken: pass and return values': '不支持指针：请传递和返回值',
  'the operator {} works on bits, and is not taken: use arithmetic': '不支持位运算符 {1}：请用算术运算',
  'the number {} is of a type that is not taken: leave the {} out': '不支持数 {1} 的类型：请去掉 {2}',

  // Functions
  '{} is a function of WGSL or of effects: call yours otherwise': '{1} 是 WGSL 或效果自有的函数：请另取名称',
  'there is a function {} already: call this one otherwise': '已经有函数 {1}：请另取名称',
  'there is no function effect: write `fn effect(p: Pixel) -> vec4f { … }`':
    '没有函数 effect：请写 `fn effect(p: Pixel) -> vec4f { … }`',
  'effect should be a function of one Pixel that returns vec4f': 'effect 应为以一个 Pixel 为参数、返回 vec4f 的函数',
  'there is no function {}: is it spelt otherwise? Textures, derivatives and bits are not taken':
    '没有函数 {1}：请检查拼写。不支持纹理、导数和位运算',
  '{} takes {}, and has {}': '{1} 需要{2}，现有 {3} 个',
  '1 value': ' 1 个值',
  '{} does not take ({})': '{1} 不接受 ({2})',
  'a Pixel cannot be returned: return its colour or a number': '不能返回 Pixel：请返回其颜色或一个数',
  'not every way through {} returns a value: end it with `return …;`':
    '{1} 并非每条路径都返回值：请以 `return …;` 结束',
  '{} calls itself, which no shader can: write a loop': '{1} 调用了自身，着色器不能这样做：请写循环',

  // Names and values
  'there is a {} already: call this one otherwise': '已经有 {1}：请另取名称',
  'the value of the const {} is not known beforehand: use `let`': 'const {1} 的值不是事先已知的：请用 `let`',
  'a Pixel cannot be kept: keep its colour, or a number of it': '不能保存 Pixel：请保存其颜色，或其中的一个数',
  'only a variable, or one component of it, can be assigned': '只能给变量或它的一个分量赋值',
  '{} is no variable here: `var {} = …;` before it': '{1} 在这里不是变量：请先写 `var {2} = …;`',
  '{} cannot be changed: declare it with `var`, or copy it into one':
    '{1} 不能更改：请用 `var` 声明，或复制到 `var` 变量中',
  'a part of a matrix cannot be assigned: build it anew': '不能给矩阵的一部分赋值：请重新构造矩阵',
  'WGSL assigns one component at a time: .x, .y, .z or .w': 'WGSL 一次只给一个分量赋值：.x、.y、.z 或 .w',
  '{} is not declared here: `let {} = …;` before it, or is it spelt otherwise?':
    '{1} 在这里没有声明：请先写 `let {2} = …;`，或检查拼写',
  '{} is more than the largest i32, 2147483647: write it with a point':
    '{1} 超过了最大的 i32，2147483647：请写成带小数点的数',
  '{} is more than the largest f32, 3.4e38': '{1} 超过了最大的 f32，3.4e38',
  'this divides a whole number by 0': '整数不能除以 0',
  'this comes to no number that f32 holds': '结果不是 f32 能表示的数',
  'no operation {}': '没有运算 {1}',

  // Types
  'the type {} is not known: there are f32, i32, bool, vec2f … vec4f, vec2i … vec4i, mat2x2f, mat3x3f, mat4x4f and Pixel':
    '没有类型 {1}：可用 f32、i32、bool、vec2f … vec4f、vec2i … vec4i、mat2x2f、mat3x3f、mat4x4f 和 Pixel',
  '{} is {}, and should be {}: convert it by {}(…)': '{1}的类型是 {2}，应为 {3}：请用 {4}(…) 转换',
  'the value of {}': '{1} 的值',
  'the new value': '新的值',
  'the returned value': '返回值',
  'what follows `if`': '`if` 之后的内容',
  'what follows !': '! 之后的内容',
  'value {} of {}': '{2} 的第 {1} 个值',
  'the offset of {}, in pixels,': '{1} 的偏移（以像素计）',
  '- does not work on {}': '- 不能用于 {1}',
  '{} does not work between {} and {}: convert one of them': '{1} 不能用于 {2} 与 {3} 之间：请转换其中一个',
  '{} compares numbers: compare the components (.x, .y …) one by one': '{1} 只比较数：请逐个比较分量（.x、.y …）',
  'a Pixel has no {}: it has position, uv, size, direction and color':
    'Pixel 没有 {1}：它有 position、uv、size、direction 和 color',
  'a Pixel is no number: take its position, uv, size, direction or color':
    'Pixel 不是数：请取其 position、uv、size、direction 或 color',
  '{} has no .{}': '{1} 没有 .{2}',
  '{} has no [{}]': '{1} 没有 [{2}]',
  'an index must be a whole number that is known: write [0], or .x': '下标须是已知的整数：请写 [0] 或 .x',
  'the values are of different types: convert them': '这些值的类型不同：请转换',
  '{} has {} components, and is given {}': '{1} 有 {2} 个分量，却给出了 {3} 个',
  'component {} of {} is {}: convert it by {}(…)': '{2} 的第 {1} 个分量的类型是 {3}：请用 {4}(…) 转换',

  // Loops and limits
  '`{}` is in no loop': '`{1}` 不在循环中',
  'the loop declares no counter of its own: write `for (var i = 0; i < 16; i++)`':
    '循环没有声明自己的计数变量：请写 `for (var i = 0; i < 16; i++)`',
  '{} counts this loop, and may not be changed in it': '{1} 为此循环计数，不能在其中更改',
  '{} counts, and should be i32': '{1} 用于计数，应为 i32',
  '{} must be a whole number that is known beforehand: a number or a `const`. Where fewer rounds are needed, leave the loop by `break`':
    '{1}须是事先已知的整数：一个数或一个 `const`。需要较少次数时，请用 `break` 离开循环',
  'the first value of {}': '{1} 的初值',
  'the step of {}': '{1} 的步长',
  'the end of {}': '{1} 的终值',
  'the loop does not count {} on by a number that is known: write {}++ or {} += 2':
    '循环没有让 {1} 按已知的数递增：请写 {2}++ 或 {3} += 2',
  '{} is counted on by 0: the loop would never end': '{1} 每次只递增 0：循环永远不会结束',
  'the loop has no end that is known: write {} < 16, with the counter on the left':
    '循环的终值未知：请写 {1} < 16，计数变量在左边',
  '{} is counted away from its end: the loop would never end': '{1} 朝远离终值的方向计数：循环永远不会结束',
  'this loop goes round {} times; more than {} are not taken: take fewer, in larger steps':
    '此循环执行 {1} 次，上限为 {2} 次：请减少次数，加大步长',
  'loops within loops of {} go round {} times; more than {} are not taken: take fewer':
    '{1} 的嵌套循环共执行 {2} 次，上限为 {3} 次：请减少次数',
  '{} has {} operations, with those of the functions that it calls; more than {} are not taken':
    '{1} 连同它调用的函数共有 {2} 个运算，上限为 {3} 个',
  '{} takes {} steps for each pixel (a look at a pixel counts {}); more than {} are not taken: let loops go round fewer times':
    '{1} 每像素需要 {2} 步（读取一个像素计 {3} 步），上限为 {4} 步：请减少循环次数',
};
