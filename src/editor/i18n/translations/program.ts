import type { MessageCatalogue } from './translateMessage.ts';

/** Messages of the project, its nodes and the page; see index.ts for the format. */
export const program: MessageCatalogue = {
  // The project and its graph
  'the project': '项目',
  'the file': '文件',
  'there is no node "{}"': '没有节点“{1}”',
  'there is no node {}': '没有节点 {1}',
  'there is no group "{}"': '没有节点组“{1}”',
  'there is no group "{}"; choose one, or remove the node': '没有节点组“{1}”；请选择一个，或删除此节点',
  'there is no node type "{}"': '没有“{1}”这种节点',
  'there is no such parameter': '没有这个参数',
  'there is already a {} "{}"': '已经有名为“{2}”的{1}',
  node: '节点',
  group: '节点组',
  frame: '分组框',
  edge: '连线',
  '"{}" cannot be a node\'s name: letters, digits, - and _': '“{1}”不能作为节点的名称：只能用字母、数字、- 和 _',
  'a name is a letter and at most 63 more letters, digits, - or _': '名称以字母开头，其后至多 63 个字母、数字、- 或 _',
  '{}, here with a number after a dot where it takes many': '{1}；可接多条连线时在点后加编号',
  'a colour is # and six digits of 0…9, a…f': '颜色写作 # 加六位 0…9、a…f',
  'a hash is 64 digits of 0…9, a…f': '散列值是 64 位 0…9、a…f',
  'format: these are no nodes of Slowlight': 'format：这些不是 Slowlight 的节点',
  'no nodes of Slowlight': '不是 Slowlight 的节点',
  'not a Slowlight project': '不是 Slowlight 项目',
  'not JSON: {}': '不是 JSON：{1}',
  '{}. Save the project again, or undo what was changed in its text.': '{1}。请重新保存项目，或撤销对其文本的改动。',
  '{}; it is {}': '{1}；现为 {2}',
  'the file: {} MiB is more than the {} MiB of a project': '文件：{1} MiB 超过了项目的上限 {2} MiB',
  'choose the nodes that the group is to hold': '请选择节点组要包含的节点',
  '{} carries the sockets of the group around it, and stays there': '{1} 承载着外层节点组的接口，须留在那里',
  'the group would feed itself over {}; take that into it too, or less':
    '节点组会经由 {1} 向自己供给；请把它也包含进来，或少选一些',
  '{} is no group': '{1} 不是节点组',
  'nothing was asked for': '没有要求任何内容',
  'nothing is connected to {}{}': '{1}{2} 没有连接',
  'groups.{}: groups lie more than {} deep': 'groups.{1}：节点组嵌套超过 {2} 层',
  'groups.{}: groups lie more than {} deep in one another': 'groups.{1}：节点组嵌套超过 {2} 层',
  'groups: opened out they make more than {} nodes; use them less often':
    'groups：展开后超过 {1} 个节点；请减少使用次数',
  'groups.{}: it holds itself: {}': 'groups.{1}：它包含自己：{2}',
  '{} feeds itself; remove one of the edges': '{1} 向自己供给；请删除其中一条连线',
  'the node feeds itself: remove one of the edges': '节点向自己供给：请删除其中一条连线',
  'this would close a cycle': '这样会形成循环',
  '{} stands in no group': '{1} 不在任何节点组中',
  'it stands in no group; remove it': '它不在任何节点组中；请删除',
  'the group {} has no group output': '节点组 {1} 没有组输出',
  'a group has one group output; remove this one': '一个节点组只有一个组输出；请删除这一个',
  'in the group {} nothing is connected to {}': '节点组 {1} 中的 {2} 没有连接',
  '{}{} is muted and has no {} to pass on; unmute it': '{1}{2} 已静音，没有可传递的 {3}；请取消静音',
  '{} ({}) does not fit {} ({})': '{1}（{2}）与 {3}（{4}）不匹配',
  '{} ({}) does not fit {} ({}); connect something else': '{1}（{2}）与 {3}（{4}）不匹配；请连接其他内容',
  'there is no output {}; connect another': '没有输出 {1}；请连接另一个',
  '{} has no output "{}"': '{1} 没有输出“{2}”',
  '{} has no input "{}"': '{1} 没有输入“{2}”',
  'connect something to "{}" ({})': '请为“{1}”（{2}）连接内容',
  '{}, or connect something else to "{}"': '{1}，或为“{2}”连接其他内容',
  '{}; an edge brings it': '{1}；由连线传来',
  'nodes: {} are more than the {} that a project may hold': 'nodes：{1} 个，超过了项目的上限 {2} 个',
  '{}{}: there is no node "{}"': '{1}{2}：没有节点“{3}”',
  '{}edges.{}: it feeds {}, and must be called so': '{1}edges.{2}：它供给 {3}，必须以此命名',
  '{}: there are two of the name "{}"': '{1}：有两个同名的“{2}”',
  '{} is none of the choices': '{1} 不在选项之中',
  '{} is not three numbers': '{1} 不是三个数',
  '{} is no list of texts': '{1} 不是文本列表',
  '{} is not a {}': '{1} 不是{2}',
  string: '文本',
  boolean: '开关值',
  '{} is not a number': '{1} 不是数',
  '{} is not a whole number': '{1} 不是整数',
  '{} is outside {} … {}': '{1} 超出 {2} … {3} 的范围',
  'groups and reroutes are removed before evaluation': '节点组和折点在求值之前展开',

  // Links
  '{} characters of the {} that a link may have': '{1} 个字符，链接至多 {2} 个',
  'the link: the project is too large ({}); save it to a file and send that':
    '链接：项目太大（{1}）；请保存为文件后发送',
  'the link: it carries no project': '链接：其中没有项目',
  'the link: {} characters are more than the {} of one of ours': '链接：{1} 个字符，超过了我们链接的上限 {2} 个',
  'the link: {}; it was cut off or changed on its way, ask for it again':
    '链接：{1}；它在传送中被截断或更改，请重新索取',
  'the link: it unpacks to more than {} bytes': '链接：解压后超过 {1} 字节',
  'what it carries is no text': '其内容不是文本',
  'it cannot be unpacked': '无法解压',
  'it has no end': '它没有结尾',
  'it has letters that no link of ours has': '它含有我们的链接不会有的字符',
  'it is not whole': '它不完整',

  // Values that are written as expressions
  'longer than {} characters': '超过 {1} 个字符',
  'a value in {} where {} is wanted': '值的单位是 {1}，而需要的是 {2}',
  'a plain number': '无单位的数',
  'no unit': '无单位',
  'this is no finite number': '这不是有限的数',
  '"{}" is not understood': '无法理解“{1}”',
  'the end': '结尾',
  'something is missing at the end': '末尾缺少内容',
  '"{}" does not belong here': '“{1}”不应出现在这里',
  '{} and {} do not add': '{1} 与 {2} 不能相加',
  'an exponent is a plain number': '指数须是无单位的数',
  'what has a unit is raised to whole numbers only': '有单位的值只能取整数次幂',
  'a bracket is not closed': '括号没有闭合',
  '"{}" is neither a unit nor a function': '“{1}”既不是单位，也不是函数',
  '{} takes {}': '{1} 需要{2}',
  'one value': '一个值',
  '{} values': ' {1} 个值',
  '{} is of plain numbers and angles': '{1} 只用于无单位的数和角度',
  'too many brackets in one another': '括号嵌套过多',

  // Simulations
  'it ended at t = {} s: {}': '于 t = {1} s 结束：{2}',
  'point {}': '点 {1}',
  'vertex {} of {}': '{2} 的顶点 {1}',
  '{}; take a smaller step': '{1}；请减小步长',
  '{} has no finite position any more; take a smaller step': '{1} 的位置已不是有限的数；请减小步长',
  '{} went through what is solid, {} ({}) m; take a smaller step, a harder penalty, or let it go slower':
    '{1} 穿过了实体，{2}（{3}）m；请减小步长、加大接触劲度，或让它慢一些',
  to: '到达',
  'soon after it was at': '在此后不久：',
  '{} is moved at {} m/s, not below c = {} m/s; move it slower':
    '{1} 被带动的速度为 {2} m/s，不低于 c = {3} m/s；请带得慢一些',
  '{} goes at {} m/s, not below c = {} m/s': '{1} 的速度为 {2} m/s，不低于 c = {3} m/s',
  'points fly apart within one step; take a smaller one': '各点在一步之内飞散；请减小步长',
  'the equations of an implicit step were not solved; take a smaller step': '隐式步的方程未能求解；请减小步长',
  'the matrix of the step is not positive definite; take a smaller step': '该步的矩阵不正定；请减小步长',
  'even steps of {} s err too much; allow a larger error': '即使步长为 {1} s，误差也太大；请允许更大的误差',
  'the energy has grown by {} J: steps of {} s are longer than {} can take here, {} s; take shorter ones':
    '能量增加了 {1} J：步长 {2} s 超过了 {3} 在此可用的 {4} s；请减小步长',
  leapfrog: '蛙跳',
  'discrete-gradient': '离散梯度',
  'implicit-midpoint': '隐式中点',
  'the GPU was lost ({}); go on, or compute it on the processor': 'GPU 已丢失（{1}）；请继续，或在处理器上计算',
  'steps of {} s are too long for {}: perturbations may grow; set a shorter step, or 0':
    '步长 {1} s 对 {2} 来说太长：微小的量可能每步增大；请设更短的步长，或设为 0',
  'by t = {} s the energy had grown without a source by more than half of the kinetic energy: an error of {}; set a shorter step, or another method':
    '至 t = {1} s，凭空出现的能量已超过运动能量的一半：这是 {2} 的误差；请设更短的步长，或换一种方法',
  'the GPU here is a software implementation; without it the simulation is faster':
    '这里的 GPU 是运行在处理器上的程序；不用它，模拟更快',
  'there is no GPU here that computes (WebGPU)': '这里没有能计算的 GPU（WebGPU）',
  'objects with prescribed motion are not supported on the GPU': '沿自己路径运动的物体不能由 GPU 带动',
  'points have several contact laws; the GPU supports one': '各点按多种规律相互接触；GPU 只支持一种',
  'it takes a buffer of {}, and the GPU gives {} at most': '它需要 {1} 的缓冲区，而 GPU 至多提供 {2}',
  "{} is not computed on the GPU; leapfrog and Yoshida's methods are": '{1} 不在 GPU 上计算；蛙跳和 Yoshida 方法可以',
  'adaptive steps are not supported on the GPU; use fixed steps': '随误差调整的步长不在 GPU 上计算；请使用等长的步长',
  'adaptive steps are not supported on the GPU; use fixed steps, with 0':
    '随误差调整的步长不在 GPU 上计算；请设为 0，使各步等长',
  'the GPU refuses: {}': 'GPU 拒绝执行：{1}',
  '{}; compute it on the processor': '{1}；请在处理器上计算',
  'a face has point {}, and there are {}': '某个面用到点 {1}，而点数为 {2}',
  'the mesh makes more than {} springs; take a coarser one': '该网格会产生超过 {1} 根弹簧；请用更粗的网格',
  '{} steps are too many': '{1} 步太多',
  'the speed of light is {} m/s; make it above 0': '光速为 {1} m/s；请设为大于 0',
  'the drag is {} 1/s; make it 0 or above': '阻力为 {1} 1/s；请设为 0 或更大',
  'there are {} points, more than {}; take a coarser mesh': '共有 {1} 个点，超过 {2} 个；请用更粗的网格',
  '{} has the mass {} kg; make it above 0': '{1} 的质量为 {2} kg；请设为大于 0',
  '{} balls and {} points make too many pairs; take fewer balls, or coarser meshes':
    '{1} 个球与 {2} 个点太多，无法计算碰撞；请减少球，或用更粗的网格',
  '{} charged points make too many pairs; charge fewer or coarser objects':
    '{1} 个带电的点太多，无法计算相互作用；请减少带电的物体，或用更粗的物体',
  'it passes on what comes in; connect something, or name a file to read instead':
    '它传递收到的内容；请连接内容，或指定要读取的文件',
  'only balls can be free; choose the shape Ball, or turn Free off': '只有球可以自由运动；请选择形状“球”，或让它固定',
  '"{}" is no number of a point, nor two with - between them; write them like 0, 9, 20-29':
    '“{1}”不是点的编号，也不是用 - 连接的两个编号；请写成 0, 9, 20-29',
  'it is not flat, so that it is no plane; choose the shape box or ball': '它不平，因此不是平面；请选择形状“盒”或“球”',
  '{} has no point {}: they are numbered from 0 to {}': '{1} 没有点 {2}：编号从 0 到 {3}',
  'there is no object with a surface; connect one': '没有带表面的物体；请连接一个',
  '{} {} already; put this before what moves it, or choose things {}':
    '{1} 已{2}；请把此节点放在使其运动的节点之前，或选择{3}的物体',
  moves: '在运动',
  'changes its shape': '在变形',
  'that keep theirs': '不变形',
  'at rest': '静止',
  'there is nothing to simulate; connect a Mass spring or a Collider': '没有可运动的物体；请连接质点弹簧或碰撞体',
  '{} frames are more than {}; keep fewer a second, or let it end sooner':
    '{1} 帧超过了 {2} 帧；请减少每秒帧数，或让它早些结束',
  '{} vertices in {} frames are more than {} samples; keep fewer frames a second, let it end sooner, or take coarser meshes':
    '{2} 帧中的 {1} 个顶点超过了 {3} 个样本；请减少每秒帧数、让它早些结束，或用更粗的网格',
  'it would take {} steps of {} s, more than {}; set a longer step, take softer springs, or let it end sooner':
    '需要 {1} 步、每步 {2} s，超过 {3} 步；请设更长的步长、用更软的弹簧，或让它早些结束',
  'no point is in the box that holds points; put it on some': '固定点的盒中没有点；请把它放到一些点上',
  'it begins at {} m/s, not below the speed of light, {} m/s; let it begin slower, or raise the speed of light of the simulation':
    '它的初速度为 {1} m/s，不低于光速 {2} m/s；请降低初速度，或提高模拟的光速',
  'it has no points; leave it out': '它没有点；请去掉它',

  // Objects, motions and pictures
  '{} c at t = {} s; raise the speed of light to {} m/s or more, or slow it down':
    't = {2} s 时为 {1} c；请把光速提高到 {3} m/s 或以上，或让它慢下来',
  '{} c is not slower than light; take less': '{1} c 不比光慢；请减小',
  '"{}" is no name of a file without folders that ends in {}; write one like {}':
    '“{1}”不是以 {2} 结尾、不含文件夹的文件名；请写成如 {3}',
  'the scene has no such object; choose another': '场景中没有这个物体；请另选一个',
  'the direction 0, 0, 0 is not a direction': '方向 0, 0, 0 不指向任何地方',
  'it deforms, and has too many samples to be carried along; let the file move it':
    '它会变形，样本太多而无法带着走；请在文件中让它运动',
  'with its own motion the flight makes it {} c at t = {} s; fly slower, or raise the speed of light':
    '连同自身的运动，飞行使它在 t = {2} s 时达到 {1} c；请飞得慢些，或提高光速',
  'that would be {} things, more than {}; take fewer': '那将是 {1} 个物体，超过 {2} 个；请减少',
  'it ends at {} s, before it begins at {} s': '它在 {1} s 结束，早于开始的 {2} s',
  '{} moves already; put this before what moves it, or choose things at rest':
    '{1} 已在运动；请把此节点放在使其运动的节点之前，或选择静止的物体',
  '"{}" cannot be a name: letters, digits and _ can, at most 64, and no digit first':
    '“{1}”不能作为名称：可用字母、数字和 _，至多 64 个，且不以数字开头',
  'no file is chosen; open one, or take one of the examples': '没有选择文件；请打开一个，或选用一个示例',
  'it is the place before it again; leave one of them out': '与前一个位置相同；请去掉其中一个',
  'its time {} s is not after {} s, that of the one before it; put them in order':
    '其时刻 {1} s 不晚于前一个的 {2} s；请按顺序排列',
  'it takes at least two; there {}': '至少需要两个；现{1}',
  'is one': '有一个',
  'are none': '一个也没有',
  'there are {}, more than {}; take fewer': '共有 {1} 个，超过 {2} 个；请减少',
  '"{}" is not {} numbers; write them with blanks between them': '“{1}”不是 {2} 个数；请用空格分隔',
  'there is nothing at "{}"; there is {}': '“{1}”处没有物体；现有 {2}',
  'nothing at all': '一无所有',
  'it shows nothing; write a letter': '它什么也显示不出来；请写一个字',
  'it would be of {} triangles, more than {}; write less, or let curves be coarser (tolerance)':
    '它会有 {1} 个三角形，超过 {2} 个；请少写一些，或让曲线更粗（容差）',
  'it has {} letters, more than {}; write less': '它有 {1} 个字，超过 {2} 个；请少写一些',
  'no font that comes with the program has {}; leave it out': '程序自带的字体都没有 {1}；请去掉它',
  '{} levels would make {} triangles, more than {}; take fewer levels, or fewer things':
    '{1} 级会产生 {2} 个三角形，超过 {3} 个；请减少级数，或减少物体',
  '{} deforms and its samples are left in their file, so that they cannot be cut; choose other things':
    '{1} 会变形，其样本留在文件中，无法细分；请选择其他物体',
  'it would turn {} times, more than {}; let it be slower, or end sooner':
    '它会转 {1} 圈，超过 {2} 圈；请让它慢些，或早些结束',
  'a picture is put together of {} {} at most; leave some out': '一幅图像至多由 {1} 个{2}组成；请去掉一些',
  'a picture is put together of {} stills at most; leave some out': '一幅图像至多由 {1} 张静态图组成；请去掉一些',
  'the picture has no such G-buffer': '图像没有这个 G 缓冲',
  'the project reads it; open it again before the project is packed': '项目要读取它；请先重新打开它，再打包项目',
  'it holds no {}; export the project again': '其中没有 {1}；请重新导出项目',
  'there is no camera {}; the scene has {}': '没有相机 {1}；场景中有 {2}',
  '{} × {} are {} pixels, more than {}; make it smaller': '{1} × {2} 共 {3} 像素，超过 {4}；请缩小',
  '{} × {} samples of {} × {} pixels are {}': '{3} × {4} 像素、每像素 {1} × {2} 个样本，共 {5}',
  '{}, more than {}; take {} × {}, or fewer pixels': '{1}，超过 {2}；请取 {3} × {4}，或减少像素',
  '{} million': '{1} 百万',
  '"{}": # stands for the numbers of frames, and this is one picture; Save Video writes several':
    '“{1}”：# 代表帧的编号，而这是单幅图像；“保存视频”可写出多幅',
  '{} frames are more than {}; let it be shorter, or of fewer frames per second':
    '{1} 帧超过了 {2} 帧；请缩短，或减少每秒帧数',
  'an .mp4 needs an even width and height; {} is {}': '.mp4 的宽和高须为偶数；{1} 为 {2}',
  width: '宽',
  height: '高',
  '"{}": several frames need a place for their number, like {}; or write an .mp4':
    '“{1}”：多帧需要编号的位置，如 {2}；或写出 .mp4',
  'false colours are for a screen, and an .exr holds light; save them as .png':
    '伪彩色用于屏幕，而 .exr 保存的是光；请保存为 .png',
  'a heavy node reads no files; give it what it needs as inputs': '耗时的节点不读取文件；请通过输入提供所需内容',
  'a heavy node has no threads of its own': '耗时的节点没有自己的线程',
  '{} of {} is no number; change one of them': '{2} 的 {1} 不是数；请更改其中之一',
  '{} of {} is beyond all numbers; take smaller ones': '{2} 的 {1} 超出一切数；请取更小的值',

  // Scenes
  '{}; it is left out': '{1}；已将其去掉',
  'two objects have this path; rename one': '两个物体有相同的路径；请重命名其中一个',
  'has no triangle; nothing of it is drawn': '没有三角形；不会画出任何内容',
  'a triangle names vertex {}, but there are only {}': '某个三角形用到顶点 {1}，而顶点只有 {2} 个',
  '{} vertices need as many normals and uvs, not {} and {}':
    '{1} 个顶点需要同样多的法线和纹理坐标，而现有 {2} 和 {3} 个',
  'uses material {}, but there are only {}': '使用材质 {1}，而材质只有 {2} 个',
  '{} of {} triangles have no area; merge double points, or leave it: they are not drawn':
    '{2} 个三角形中有 {1} 个面积为零；请合并重复的点，或置之不理：它们不会被画出',
  '{} times and {} samples; a motion needs as many of both, two or more':
    '{1} 个时刻和 {2} 个样本；运动需要二者数目相同，至少两个',
  'sample {} is at {}, not after sample {} at {}; times must rise':
    '样本 {1} 在 {2}，不晚于样本 {3} 的 {4}；时刻必须递增',
  'ends at {}, not after it begins at {}; it is never there': '结束于 {1}，不晚于开始的 {2}；它从不存在',
  'deforming points are authored in the rest frame, which they do not share; they are taken as the world’s':
    '变形的点按静止系给出，但它们没有共同的静止系；已按世界系处理',
  'vertex {} is at {}': '顶点 {1} 位于 {2}',
  'the pose at {} has {} in it': '{1} 时的姿态含有 {2}',
  'the points or velocities at {} have a number that is not finite': '{1} 时的点或速度含有非有限的数',
  'its pose or motion has {} in it': '其姿态或运动含有 {1}',
  'motion of {}': '{1} 的运动',
  'between samples its cubic path could reach {} c, first at t = {}; {} of {} pieces are shown straighter, by up to {} %, and velocities jump there; raise c above {} m/s or write more samples':
    '样本之间的三次曲线可能达到 {1} c，最早在 t = {2}；{4} 段中有 {3} 段画得更直（至多 {5} %），速度在那里会跳变；请把 c 提高到 {6} m/s 以上，或写入更多样本',
  '{} c between t = {} and {}; raise c above {} m/s or slow it down':
    't = {2} 至 {3} 之间为 {1} c；请把 c 提高到 {4} m/s 以上，或让它慢下来',
  '{} c at all times; raise c above {} m/s or slow it down': '始终为 {1} c；请把 c 提高到 {2} m/s 以上，或让它慢下来',
  'a point {} m behind its origin would have to outrun light (horizon at {} m); raise c above {} m/s or accelerate less':
    '其原点之后 {1} m 处的点须超过光速（视界在 {2} m 处）；请把 c 提高到 {3} m/s 以上，或减小加速度',
  'its {} is {} m': '其 {1} 为 {2} m',
  '{}; give it a size of 0 m or more': '{1}；请设为 0 m 或更大',
  'its colour is {}; give it three numbers': '其颜色为 {1}；请给出三个数',

  // Opening and saving
  'it is not what was opened any more, or is gone; open the scene again':
    '它已不是打开时的文件，或已不存在；请重新打开场景',
  'the font {} cannot be loaded: the server answers {}': '无法取得字体 {1}：服务器回答 {2}',
  'the file grew while it was read; open it again': '文件在读取时变大了；请重新打开',
  'none of its files is a scene': '其中没有场景文件',
  'there is no such file; put it beside the project, or open it': '没有这个文件；请把它放在项目旁边，或打开它',
  'the file was opened in an earlier session; open it again': '文件是在之前的会话中打开的；请重新打开',
  'the reader did not give the scene': '读取器没有给出场景',
  'the reader did not give the files': '读取器没有给出文件',
  'the reader could not be started': '无法启动读取器',
  'examples/index.json: the server answers {}': 'examples/index.json：服务器回答 {1}',
  '{}: the server answers {} {}': '{1}：服务器回答 {2} {3}',
  'the server answers {}; check the address': '服务器回答 {1}；请检查地址',
  'it holds no .slowlight.json; save the project with its files again':
    '其中没有 .slowlight.json；请重新连同文件保存项目',
  '{} bytes are more than a project has; it holds words, not data':
    '{1} 字节超过了项目应有的大小；项目只含文字，不含数据',
  '{} are more than a page packs': '{1} 超过了页面能打包的大小',
  'the node asks for no file': '该节点不需要文件',
  'the browser made no PNG': '浏览器没有生成 PNG',
  'a worker could not be started': '无法启动工作线程',
  'it has no output node, so that it makes no picture; undo, or add one':
    '项目没有输出节点，因此没有图像；请撤销，或添加一个',
  'it waits for what is under way': '它在等待正在进行的工作',
};
