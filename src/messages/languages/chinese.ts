import type { Translation } from '../translation.ts';

/**
 * Chinese. A key is the English template with {} for each value; {1} in the translation is the first value. A test names
 * messages of the source that are missing here, and those that are here and no longer there.
 */
const messages: Translation['messages'] = {
  // ———— Joins ————
  '{} ({})': '{1}（{2}）',
  '{}; or {}.': '{1}；或{2}。',
  '{}: {}': '{1}：{2}',
  '{} or {}': '{1} 或 {2}',
  '{}, {}': '{1}、{2}',

  // ———— OpenUSD ————
  '{}; write it as text, .usda': '{1}；请写为文本（.usda）',
  'a payload has customData, which binary files keep of references only':
    '载荷带有 customData，而二进制文件只为引用保存它',
  'of the integers {} some do not fit 64 bits': '整数 {1} 中有的超出 64 位',
  'a list of unknown metadata has an item of type {}': '未知元数据的列表中有类型为 {1} 的项',
  'a binary layer of more than {} cannot be written; write fewer samples, or fewer objects':
    '无法写出超过 {1} 的二进制图层；请减少样本或物体',
  '{} bytes are more than an LZ4 block holds': '{1} 字节超出 LZ4 块的容量',
  'the sublayer @{}@ has a path or customData, which only references have':
    '子图层 @{1}@ 带有路径或 customData，而只有引用可以带',
  'a spline of type {} is not one of double, float, half or timecode':
    '样条的类型 {1} 不是 double、float、half 或 timecode',
  'the text {} has the character U+0000': '文本 {1} 中有字符 U+0000',
  'values of type {} cannot be written': '类型为 {1} 的值无法写出',
  'relocates of a prim are no longer in USD; the layer can have them':
    'USD 已不再支持 prim 的 relocates；图层可以带有它们',
  'a spline is of version {}; 1 to 3 are read. Write the layer as text: usdcat':
    '样条的版本为 {1}；只能读取 1 到 3。请用 usdcat 将图层写为文本',
  'a spline has values of an unknown type': '样条的值类型未知',
  'a field': '字段',
  'its list of fields begins at {} of {} and has no end': '其字段列表从 {2} 项中的第 {1} 项开始，没有结尾',
  header: '文件头',
  metadata: '元数据',
  // The stage and its objects
  '{} changes with time; it is held at the start': '{1} 随时间变化；已保持起始时的值',
  'it changes with time; it is held at the start': '它随时间变化；已保持起始时的值',
  'an orthographic camera is read as a perspective one': '正交相机已按透视相机读取',
  'model:drawMode is {}, and nothing tells its size (extentsHint, or points below it); the model itself is drawn':
    'model:drawMode 为 {1}，但无从得知其大小（extentsHint 或其下的点）；已绘制模型本身',
  'model:cardGeometry is {}, which is not read ({} are); its cards are a cross':
    '不支持 model:cardGeometry 的值 {1}（支持 {2}）；其卡片按 cross 放置',
  'it ends too early': '结束得过早',
  'its codes are damaged': '编码已损坏',
  'its code books are damaged': '码本已损坏',
  'a block is damaged': '有数据块已损坏',
  'too many levels': '层级过多',
  'several pictures': '多幅图片',
  'supercompression {}': '超级压缩方式 {1}',
  'format {} of Vulkan': 'Vulkan 格式 {1}',
  'the KTX2 is damaged or cut off ({}); export it again': 'KTX2 已损坏或被截断（{1}）；请重新导出',
  'the picture is a KTX2 with {}, which is not read; convert it to Basis Universal, PNG or JPEG':
    '图片是含{1}的 KTX2，不能读取；请转换为 Basis Universal、PNG 或 JPEG',
  'vertices follow more than 4 joints; programs that read only the first 4 show it otherwise':
    '有顶点跟随 4 个以上的关节；只读取前 4 个关节的程序会显示得不同',
  'its points follow different joints, which is read of meshes only; these {} stay as they are written':
    '其各点跟随不同的关节，这仅支持网格；这些 {1} 保持原样',
  '{} is not constant, and a {} has no points': '{1} 不是 constant，而 {2} 没有点',
  '{} is not read; it is left out': '不支持读取 {1}；已去掉',
  '{} is not read; it is left out (export it as a mesh)': '不支持读取 {1}；已去掉（请导出为网格）',
  '{} is not read; it is left out (export its surface as a mesh)': '不支持读取 {1}；已去掉（请将其表面导出为网格）',
  '{} is a light that is not read': '不支持读取光源 {1}',
  'the spline of {} is not read yet (write the values as time samples)':
    '尚不支持读取 {1} 的样条（请将其值写为时间样本）',
  '{} = {} is not a positive number': '{1} = {2} 不是正数',
  'metersPerUnit is not written; one unit is taken as 1 cm, as USD says':
    '没有写明 metersPerUnit；已按 USD 的规定取一个单位为 1 cm',
  "an 'over' changes this prim, and nothing defines it; it is left out": '有“over”更改此 prim，却没有定义它；已去掉',
  'its visibility changes with time, and a {} has no lifetime: it is held at the start':
    '其可见性随时间变化，而 {1} 没有存在时间：已保持起始时的值',
  'its topology changes: {} meshes take turns, each alive until the next':
    '其拓扑随时间变化：{1} 个网格依次出现，每个存在到下一个出现为止',
  'its topology changes: {} meshes take turns, each alive until the next; {} of them have no velocities, so they rest while they live and show no Doppler effect of their own (write velocities)':
    '其拓扑随时间变化：{1} 个网格依次出现，每个存在到下一个出现为止；其中 {2} 个没有速度，因而在存在期间静止，不显示自身的多普勒效应（请写出 velocities）',
  'its topology changes {} times, more than there is room for; {} of its shapes are shown, each until the next (write fewer samples, or smaller ones)':
    '其拓扑变化 {1} 次，超出容量；已显示其中 {2} 个形状，每个显示到下一个为止（请写出更少或更小的样本）',
  'its topology changes with time, and it may be skinned: it is held at the start':
    '其拓扑随时间变化，而它可能带有蒙皮：已保持起始时的值',
  'it exists at {} separate times, and a scene has room for {} more objects; the first are shown':
    '它在 {1} 段分开的时间内存在，而场景只能再容纳 {2} 个物体；已显示最前面的',
  "xformOpOrder names '{}', which is no transform of this prim; it is left out":
    'xformOpOrder 列出了“{1}”，它不是此 prim 的变换；已去掉',
  'xformOpOrder names {} transforms; the first {} are used (write their product as one matrix)':
    'xformOpOrder 列出了 {1} 个变换；已采用前 {2} 个（请将其乘积写为一个矩阵）',
  'slowlight:motion and time samples both move it; it keeps its pose of t = {} s and moves as slowlight:motion says':
    'slowlight:motion 与时间样本都使它运动；它保持 t = {1} s 时的姿态，并按 slowlight:motion 运动',
  'slowlight:motion is "{}" without slowlight:{}, a vector3d; it rests':
    'slowlight:motion 为“{1}”，但没有 vector3d 类型的 slowlight:{2}；它保持静止',
  'slowlight:motion "{}" is not uniform or hyperbolic; it is left out':
    'slowlight:motion“{1}”不是 uniform 或 hyperbolic；已去掉',
  'slowlight:{} is {}, not a whole number from {} to {}; it is left out':
    'slowlight:{1} 为 {2}，不是 {3} 到 {4} 之间的整数；已忽略',
  'slowlight:authoredIn "{}" is not world or rest; world is taken':
    'slowlight:authoredIn“{1}”不是 world 或 rest；已采用 world',
  'it is moved by {} samples, and all things of the scene together by more than there is room for; {} of its samples are used (write out fewer, or move fewer things apart)':
    '它的运动有 {1} 个样本，而场景中所有物体的样本总数超过上限；已采用其中 {2} 个（请减少样本，或减少各自运动的物体）',
  'it jumps or turns too fast between its {} samples to be followed: about {} samples would be needed, {} are used, and paths are off by up to {} m; write more samples, or let it turn less between them':
    '它在 {1} 个样本之间跳动或转动太快，无法跟随：约需 {2} 个样本，已采用 {3} 个，路径偏差至多 {4} m；请写入更多样本，或让它在样本之间少转一些',

  // Meshes
  'the mesh has no {}; it is left out': '网格没有 {1}；已去掉',
  'the mesh has no faces; it is left out': '网格没有面；已去掉',
  '{} of {} faces have fewer than 3 corners or name points that are not there; they are left out':
    '{2} 个面中有 {1} 个的角不足 3 个，或用到不存在的点；已去掉这些面',
  'its velocities are not given for each of {} points at each of {} samples; they are taken from the points':
    '没有为 {1} 个点在 {2} 个样本处都给出速度；已由点的位置求得',
  "its {} vertices at {} times take more memory than there is for a scene's points; {} of the times are used":
    '其 {1} 个顶点在 {2} 个时刻所占的内存超过了场景中点的上限；已采用其中 {3} 个时刻',
  'its samples are too many for memory and stay in their file; between them its points go straight':
    '其样本太多，内存容纳不下，因而留在文件中；各点在样本之间沿直线运动',
  'its samples are too many to be subdivided and stay in their file; it is drawn as its polygons':
    '其样本太多，无法细分，因而留在文件中；已按其多边形绘制',
  'between its {} samples its points go straight; along cubics they would be up to {} m elsewhere':
    '在 {1} 个样本之间，各点沿直线运动；若沿三次曲线，位置至多相差 {2} m',
  'between its {} samples its points go along cubics; straight they would be up to {} m elsewhere':
    '在 {1} 个样本之间，各点沿三次曲线运动；若沿直线，位置至多相差 {2} m',
  '{} is meant as subdivision surface; it is drawn as its polygons': '{1} 本是细分曲面；已按其多边形绘制',
  '{} meshes (the first is {}) are meant as subdivision surface; it is drawn as its polygons':
    '{1} 个网格（第一个是 {2}）本是细分曲面；已按其多边形绘制',
  '{} subdivision surfaces (the first is {}) are subdivided at most {} times: more would change about a pixel or less where one fills a picture of {} rows':
    '{1} 个细分曲面（第一个是 {2}）最多细分 {3} 次：当其中一个充满 {4} 行的画面时，再细分只会改变约一个像素或更少',
  '{} is subdivided {} times: more would change about a pixel or less where it fills a picture of {} rows':
    '{1} 细分 {2} 次：当它充满 {3} 行的画面时，再细分只会改变约一个像素或更少',
  "it is subdivided {} times, not {}: a scene's surfaces share {} faces, instances counted {}":
    '它细分了 {1} 次，而不是 {2} 次：场景中的曲面共用 {3} 个面，计入实例则为 {4} 个',
  'subdivisionScheme loop takes triangles only; it is drawn as its polygons':
    'subdivisionScheme loop 只支持三角形；已按其多边形绘制',
  "{} '{}' is not {}; {} is taken": '{1}“{2}”不是 {3}；已采用 {4}',
  'creaseIndices names points that are not there': 'creaseIndices 列出了不存在的点',
  'creaseLengths, creaseIndices and creaseSharpnesses do not fit each other':
    'creaseLengths、creaseIndices 与 creaseSharpnesses 互不匹配',
  '{}; the creases are left out': '{1}；已去掉折痕',
  'cornerIndices and cornerSharpnesses do not fit each other or the points; the corners are left out':
    'cornerIndices 与 cornerSharpnesses 互不匹配，或与点不匹配；已去掉角点',
  '{} has an index outside its {} values; it is left out': '{1} 的某个索引超出其 {2} 个值；已去掉',
  '{} has {} values where {} are needed; it is left out': '{1} 有 {2} 个值，而需要 {3} 个；已去掉',

  // Points and curves
  'it has {} curves; the first {} are drawn, since their surface has at most {} points':
    '有 {1} 条曲线；因其表面最多有 {3} 个点，只绘制前 {2} 条',
  'its curveVertexCounts need {} points, and it has {}': '其 curveVertexCounts 需要 {1} 个点，而只有 {2} 个',
  'it has {} points; one in {} is drawn, since at most {} are': '有 {1} 个点；最多绘制 {3} 个，因此每 {2} 个绘制一个',
  'its velocities are not used: they need one for each point, and a stage with startTimeCode and endTimeCode':
    '未使用其速度：需要每个点各有一个速度，且舞台有 startTimeCode 和 endTimeCode',
  'there is nothing to draw in these {}; they are left out': '这些 {1} 没有可绘制的内容；已去掉',
  'the number of its points changes with time; it is held at the start': '其点数随时间变化；已保持起始时的值',

  // Materials and textures
  'its material {} {}; its displayColor is drawn': '其材质 {1} {2}；已绘制其 displayColor',
  'has no surface that can be read': '没有可读取的表面',
  'is not in this file': '不在此文件中',
  '{} is no asset, as @leaf.csv@; it is left out': '{1} 不是 @leaf.csv@ 这样的资源；已去掉',
  '{} is left out, for the surface is painted by its diffuseColor': '已去掉 {1}，因为表面由其 diffuseColor 着色',
  'its textures use {} in two ways; the first is used for both': '其纹理以两种方式使用 {1}；二者都采用第一种',
  'its textures use {} and {}; the first is used for both': '其纹理使用 {1} 和 {2}；二者都采用第一个',
  '{} of this material is not drawn': '此材质的 {1} 不会被绘制',
  '{}; {}': '{1}；{2}',
  "it is made of '{}', which is not read, and has no UsdPreviewSurface; {} drawn":
    '它使用“{1}”，不支持读取，也没有 UsdPreviewSurface；已绘制{2}',
  'without an id': '没有 id 的着色器',
  'its picture and finish are': '其图像和表面质感',
  'its base colour and finish are': '其基色和表面质感',
  'the displayColor is': '其 displayColor',
  'its surface has the colour of its inputs': '其表面采用其输入的颜色',
  'its materials read colours {} and {}; the first is used for both': '其材质读取颜色 {1} 和 {2}；二者都采用第一个',
  'only subsets of faces can have a material; it is left out': '只有面的子集可以有材质；已去掉',
  'its materials use uvs {}; {} is used': '其材质使用纹理坐标 {1}；已采用 {2}',
  "its material reads uvs '{}', which it does not have": '其材质读取纹理坐标“{1}”，而它没有',
  'a primvar drives a number of this material; its fallback is drawn':
    '此材质的某个数值由 primvar 驱动；已按其后备值绘制',
  "a shader '{}' is not read; the input that it drives keeps its own value":
    '不支持读取着色器“{1}”；它驱动的输入保持自己的值',
  "a shader '{}' is not read; st is used for uv": '不支持读取着色器“{1}”；纹理坐标已采用 st',
  'the texture names no file': '纹理没有指明文件',

  // Missing layers
  '{} references, payloads and sublayers lead to {} layers that are not there ({}); open the folder that holds them':
    '{1} 个引用、负载和子图层指向 {2} 个不存在的图层（{3}）；请打开它们所在的文件夹',
  'there is nothing to see: {} references to layers that are not there, and nothing else; open the folder that holds them':
    '没有可看的内容：只有 {1} 个指向不存在图层的引用；请打开它们所在的文件夹',

  // MaterialX
  'includes more than {} documents': '包含的文档超过 {1} 个',
  '{}, line {}': '{1}，第 {2} 行',
  "includes '{}', which is no path of a file": '包含的“{1}”不是文件路径',
  "includes '{}', which is not there (looked for {}); open the folder that holds it":
    '包含的“{1}”不存在（已查找 {2}）；请打开它所在的文件夹',
  "'{}' includes itself": '“{1}”包含了自身',
  'its first element is <{}>, so it is no MaterialX document': '其首个元素是 <{1}>，因此不是 MaterialX 文档',
  "is MaterialX of version '{}'; only 1.x is read": '是版本为“{1}”的 MaterialX；只能读取 1.x',
  'line {}: its materials and graphs make more than {} prims': '第 {1} 行：其材质和节点图产生的基元超过 {2} 个',
  "line {}: <surfacematerial> '{}' names the shader '{}', which is not there":
    '第 {1} 行：<surfacematerial>“{2}”引用的着色器“{3}”不存在',
  'line {}: its own nodes are nested more than {} deep': '第 {1} 行：其自定义节点的嵌套超过 {2} 层',
  "{}, line {}: the input '{}' of <{}> '{}' has the value '{}', which is no {}; it is left out":
    '{1}，第 {2} 行：<{4}>“{5}”的输入“{3}”的值“{6}”不是 {7}；已去掉',
  'its looks are not read; bind its materials to prims in a USD layer (material:binding)':
    '不支持读取其 look；请在 USD 图层中把材质绑定到基元（material:binding）',
  'line {}: <material> is of MaterialX before 1.38, and is not read (save it with MaterialX 1.38 or later)':
    '第 {1} 行：<material> 属于 1.38 之前的 MaterialX，不支持读取（请用 MaterialX 1.38 或更高版本保存）',
  'the document has {}; at most {} are read': '文档大小为 {1}；最多读取 {2}',
  'the XML is not well-formed: {}': 'XML 格式不正确：{1}',
  'elements are nested more than {} deep': '元素的嵌套超过 {1} 层',
  'there is no element': '没有任何元素',
  'its displacement is not drawn': '其置换不会被绘制',
  "its colour space '{}' is not known; it is taken as linear": '其色彩空间“{1}”未知；已视为线性',
  'its network has more than {} nodes in a row or {} in all; the rest is left out':
    '其网络的一条链超过 {1} 个节点，或总数超过 {2} 个；其余已去掉',
  "the pattern '{}' is not drawn; its mean is": '图案“{1}”不会被绘制；已绘制其平均值',
  "the node '{}' mixes textures that are placed in different ways, or coordinates, which is not drawn":
    '节点“{1}”混合了放置方式不同的纹理或坐标，不会被绘制',
  "the node '{}' gives no finite value; 0 is drawn": '节点“{1}”未给出有限值；已绘制 0',
  "the node '{}' is not read; the input that it drives keeps its own value":
    '不支持读取节点“{1}”；它所驱动的输入保留自己的值',
  'its texture coordinates are sheared, which is not drawn': '其纹理坐标带有切变，切变不会被绘制',
  "'hextiledimage' is drawn as 'tiledimage'": '“hextiledimage”已按“tiledimage”绘制',
  'its texture coordinates are computed in a way that is not read; those of the mesh are used':
    '不支持读取其纹理坐标的计算方式；已使用网格的纹理坐标',
  '{} is no normal map; it is not drawn': '{1} 不是法线贴图；不会被绘制',
  '{} is drawn as a diffuse colour, without light that travels below the surface':
    '{1} 已绘制为漫反射颜色，不含在表面之下传播的光',
  '{} and what it acts on lie on the surface in different ways; it is not drawn':
    '{1} 与它所作用的量在表面上的贴法不同，不会被绘制',
  '{} varies over the surface, which is not drawn': '{1} 在表面上的变化不会被绘制',

  // Lights
  'the light changes with time; it is held at the start': '光源随时间变化；已保持起始时的值',
  'its multiplier for diffuse light, {}, is taken for specular light too': '其漫反射系数 {1} 也用于镜面反射',
  'the IES profile of the light is not applied': '未采用光源的 IES 配光',
  'the focus tint of the light is not applied': '未采用光源的聚焦染色',
  'the want of shadows of the light is not applied': '未采用光源不投阴影的设置',
  'its texture shines with its mean colour': '其纹理以平均颜色发光',
  'it is seen to shine; what it lights, the reference renderer alone shows':
    '可以看到它发光；它照亮的景物只有参考渲染器才会显示',
  'the format {} of its picture is not read, so it shines in its colour alone; convert the picture to latlong':
    '不支持读取其图像的格式 {1}，因而它只以自身颜色发光；请将图像转换为 latlong',
  'its picture of {} × {} pixels is taken for one by latitude and longitude; of a mirror ball inputs:texture:format should say "mirroredBall" or "angular"':
    '其 {1} × {2} 像素的图像已按经纬图处理；若是镜面球，inputs:texture:format 应为 "mirroredBall" 或 "angular"',

  // Instances
  '{} has {} values for {} instances; it is left out': '{1} 有 {2} 个值，而实例有 {3} 个；已去掉',
  'its instances would be {} objects, and a scene has room for {} more; it is left out':
    '其实例共有 {1} 个物体，而场景只能再容纳 {2} 个；已去掉',
  'it is in one of its own prototypes, which would go on for ever; it is left out there':
    '它位于自己的原型之中，会无限重复；已在该处去掉',
  'its prototype <{}> is not in the stage; its instances are left out': '场景中没有其原型 <{1}>；已去掉其实例',
  'protoIndices[{}] is {}, but there are {} prototypes; {} such instances are left out':
    'protoIndices[{1}] 为 {2}，但原型只有 {3} 个；已去掉 {4} 个这样的实例',
  'it has more than {} instances at all its times together; from t = {} on it is held':
    '它在所有时刻的实例总数超过 {1} 个；从 t = {2} 起保持不变',
  'two of its ids are the same': '其中两个 id 相同',
  'it has {} ids for {} instances': '它有 {1} 个 id，而实例有 {2} 个',
  '{}; its instances are known by their places instead': '{1}；已改按位置识别其实例',
  '{} has {} values at t = {}, for {} instances; {}': '{1} 在 t = {3} 时有 {2} 个值，而实例有 {4} 个；{5}',
  'they are left out': '已去掉这些实例',
  '{} are left out': '已去掉 {1}',
  'a {} in a prototype of instances is not read; it is left out': '不支持读取实例原型中的 {1}；已去掉',

  // Skeletons and blend shapes
  'skel:animationSource leads here, which is no SkelAnimation; it rests':
    'skel:animationSource 指向此处，而此处不是 SkelAnimation；它保持静止',
  '{}; its joints rest': '{1}；其关节保持静止',
  '{} at time {}': '时刻 {2} 的 {1}',
  '{} has {} values for {} joints': '{1} 有 {2} 个值，而关节有 {3} 个',
  '{} holds what is no finite number': '{1} 含有非有限的数',
  '{}; the mesh stays as it is written': '{1}；网格保持原样',
  'skel:skeleton leads to {}, where no Skeleton is; the mesh stays as it is written':
    'skel:skeleton 指向 {1}，而该处没有 Skeleton；网格保持原样',
  '{} has no value': '{1} 没有值',
  '{} has {} values, and {} has {}': '{1} 有 {2} 个值，而 {3} 有 {4} 个',
  '{} has elementSize {}, not 1 to {}': '{1} 的 elementSize 为 {2}，不在 1 到 {3} 之间',
  '{} has {} values; with elementSize {} and interpolation {} it needs {}':
    '{1} 有 {2} 个值；elementSize 为 {3}、interpolation 为 {4} 时需要 {5} 个',
  '{}[{}] is {} of {} joints': '{1}[{2}] 为 {3}，而关节有 {4} 个',
  '{}[{}] is {}': '{1}[{2}] 为 {3}',
  "skel:joints names '{}', which is no joint of {}": 'skel:joints 列出了“{1}”，它不是 {2} 的关节',
  '{} is no matrix of finite numbers': '{1} 不是由有限的数组成的矩阵',
  "{} '{}' is not known; classicLinear is taken": '无法识别 {1}“{2}”；已采用 classicLinear',
  'skel:blendShapes has {} names for {} skel:blendShapeTargets; its blend shapes are left out':
    'skel:blendShapes 有 {1} 个名称，而 skel:blendShapeTargets 有 {2} 个；已去掉其混合形状',
  'blendShapeWeights needs {} finite numbers, one for each of blendShapes; the shapes are left out':
    'blendShapeWeights 需要 {1} 个有限的数，与 blendShapes 一一对应；已去掉这些形状',
  '{}; it does not bend {}': '{1}；它不使 {2} 变形',
  'there is no BlendShape': '没有 BlendShape',
  'pointIndices[{}] is {} of {} points': 'pointIndices[{1}] 为 {2}，而点有 {3} 个',
  '{} needs a weight other than 0 and 1': '{1} 的权重须不同于 0 和 1',
  'two inbetweens have the same weight': '两个中间形状的权重相同',
  '{} has {} offsets where {} are needed': '{1} 有 {2} 个偏移，而需要 {3} 个',
  '{}; its meshes stay as they are written': '{1}；其网格保持原样',
  'joints is empty': 'joints 为空',
  'bindTransforms has {} matrices for {} joints': 'bindTransforms 有 {1} 个矩阵，而关节有 {2} 个',
  'bindTransforms[{}] has no inverse': 'bindTransforms[{1}] 没有逆矩阵',
  'restTransforms has {} usable matrices for {} joints, and no animation moves all of them':
    'restTransforms 有 {1} 个可用的矩阵，而关节有 {2} 个，且没有动画带动所有关节',
  'joints[{}] is more than {} joints deep': 'joints[{1}] 的层级超过 {2} 个关节',
  "joints names '{}' twice": 'joints 两次列出“{1}”',

  // Composition: layers, references, payloads, classes, relocates, variants
  'it {}s {}, which is not the path of a prim; that is left out': '它{1} {2}，而这不是 prim 的路径；已去掉',
  inherit: '继承',
  specialize: '特化',
  reference: '引用',
  payload: '载荷',
  relocate: '重定位',
  'the sublayer {}': '子图层 {1}',
  'the sublayer @{}@ of {} is one of its own sublayers; it is left out there':
    '{2} 的子图层 @{1}@ 是它自己的子图层；已在该处去掉',
  'the sublayer @{}@ of {} is nested deeper than {}; it is left out there':
    '{2} 的子图层 @{1}@ 嵌套超过 {3} 层；已在该处去掉',
  'the sublayer {} of {} is left out: {}': '已去掉 {2} 的子图层 {1}：{3}',
  'the sublayer @{}@ of {} has the offset {} and the scale {}, which are no times; they are left out':
    '{2} 的子图层 @{1}@ 的偏移为 {3}、缩放为 {4}，不是有效的时间；已去掉偏移和缩放',
  '@{}@ is layer {} of the scene; so many are read': '@{1}@ 是场景的第 {2} 个图层；图层过多，不再读取',
  '@{}@ is not there (looked for {}); open the folder that holds it':
    '@{1}@ 不存在（已查找 {2}）；请打开其所在的文件夹',
  '@{}@ cannot be read: {}': '无法读取 @{1}@：{2}',
  'arcs to {} are nested more than {} deep; they are left out there': '指向 {1} 的组合弧嵌套超过 {2} 层；已在该处去掉',
  'more than {} sites have opinions on it; the rest is left out': '超过 {1} 处对它有定义；其余已去掉',
  'the {} of {} in {} to {} leads back to where it comes from; it is left out':
    '{3} 中 {2} 到 {4} 的{1}又回到出发处；已去掉',
  'its {} {} leads to {}, which {} does not have': '其{1} {2} 指向 {3}，而 {4} 中没有',
  '{} has no defaultPrim': '{1} 没有 defaultPrim',
  '{} is not the path of a prim': '{1} 不是 prim 的路径',
  'its {} {} is left out: {}': '已去掉其{1} {2}：{3}',
  'its {} @{}@ is left out: {}': '已去掉其{1} @{2}@：{3}',
  'its reference {}': '其引用：{1}',
  'its payload {}': '其载荷：{1}',
  'its {} {} has the offset {} and the scale {}, which are no times; they are left out':
    '其{1} {2} 的偏移为 {3}、缩放为 {4}，不是有效的时间；已去掉偏移和缩放',
  'the relocate of {} to {}: {}; it is left out': '{1} 到 {2} 的重定位：{3}；已去掉',
  'it is not from prim to prim': '它不是从 prim 到 prim',
  'root prims cannot be moved': '根 prim 不能移动',
  'one of them is in the other': '二者一个在另一个之中',
  '{} goes there as well': '{1} 也移到该处',
  '{} goes to {}': '{1} 移到 {2}',
  'what is around it is moved away': '其外层已被移走',
  'what is around the source is moved away': '来源的外层已被移走',
  '{} is moved to {} by a relocate, and opinions on it in {} do not count; write them at {}':
    '{1} 已由重定位移到 {2}，{3} 中对它的定义无效；请写在 {4} 处',
  'prims nested more than {} deep are left out': '已去掉嵌套超过 {1} 层的 prim',
  'the clips of the stage make more than {} samples; from here on they are left out':
    '场景的片段产生超过 {1} 个样本；从这里起已去掉',
  'the stage has more than {} prims': '场景有超过 {1} 个 prim',
  'its layers write {} prims and properties, and their arcs make more of them than can be followed; {} prims are made':
    '其图层写有 {1} 个 prim 和属性，组合弧由此产生的数量多得无法处理；已生成 {2} 个 prim',
  '{}; the rest is left out, from here on': '{1}；从这里起，其余已去掉',
  "the variant '{}' of '{}' is chosen, but {} has {}": '已选择“{2}”的变体“{1}”，但 {3} 只有 {4}',
  "the variant '{}' of '{}' is chosen, but {} is not a variant set of this prim":
    '已选择“{2}”的变体“{1}”，但 {3} 不是此 prim 的变体集',

  // Value clips
  'the clip {}': '片段 {1}',
  "its clip set '{}' is left out: {}": '已去掉其片段集“{1}”：{2}',
  "its primPath '{}' is not the path of a prim": '其 primPath“{1}”不是 prim 的路径',
  'its assetPaths are no list of assets': '其 assetPaths 不是资源列表',
  'its active names clip {}, and there are {}': '其 active 用到片段 {1}，而片段有 {2} 个',
  'its clip {} has no path': '其片段 {1} 没有路径',
  'two clips are active from {} on': '从 {1} 起有两个片段同时启用',
  'its times have more than two entries for {}': '其 times 中 {1} 有两个以上的条目',
  'its times are not all finite': '其 times 并非都是有限的数',
  'none of its clips is active': '没有启用任何片段',
  "its templateAssetPath '{}' has no group of # between dots, or more than two":
    '其 templateAssetPath“{1}”的点之间没有 # 组，或多于两组',
  'it has no templateStartTime, templateEndTime or templateStride':
    '它没有 templateStartTime、templateEndTime 或 templateStride',
  'its template goes from {} to {} in steps of {}, which does not end': '其模板从 {1} 到 {2}，步长 {3}，不会终止',
  'its template stands for more than {} clips': '其模板代表超过 {1} 个片段',
  'its templateActiveOffset {} is more than the stride {}': '其 templateActiveOffset {1} 大于步长 {2}',

  // Expressions
  'it makes {}, not text': '其结果是{1}，不是文本',
  'a list': '列表',
  'an integer': '整数',
  'a string': '文本',
  'a boolean': '布尔值',
  "it does not begin with '`'": '它不以“`”开头',
  "it does not end with '`' there": '它没有在该处以“`”结尾',
  '{} (character {} of {})': '{1}（{3} 的第 {2} 个字符）',
  'it takes too many steps': '步骤过多',
  'here is no expression': '此处没有表达式',
  'there is no function {}': '没有函数 {1}',
  '{} does not take {} arguments': '{1} 不接受 {2} 个参数',
  '{} is too large': '{1} 太大',
  'the text is not closed with {}': '文本没有以 {1} 结束',
  'it makes too long a text': '其结果文本过长',
  'a variable has a name of letters, digits and _': '变量名由字母、数字和 _ 组成',
  'a fallback value is missing': '缺少后备值',
  "the variable is not closed with '}'": '变量没有以“}”结束',
  'there is no value for the variable {}': '变量 {1} 没有值',
  'the variable {} is made of itself': '变量 {1} 由它自己构成',
  'a list holds items of one kind': '列表中的各项须为同一类型',
  "'{}' is missing": '缺少“{1}”',
  'the variable {} is {}, not text': '变量 {1} 是{2}，不是文本',
  '{} asks for True or False, not {}': '{1} 需要 True 或 False，而不是{2}',
  '{} cannot compare {} with {}': '{1} 不能比较{2}与{3}',
  'both values of if are of one kind': 'if 的两个值须为同一类型',
  'contains cannot look for {} there': 'contains 不能在该处查找{1}',
  'at takes an integer, not {}': 'at 需要整数，而不是{1}',
  'there is no item {}': '没有第 {1} 项',
  'text is asked for, not {}': '需要文本，而不是{1}',
  'a list or text is asked for, not {}': '需要列表或文本，而不是{1}',

  // The text of a layer: what is expected, and where
  "expected {}, found '{}'": '此处应为{1}，却是“{2}”',
  'expected {}, found the end of the file; it may be cut off': '此处应为{1}，文件却已结束；它可能被截断',
  "'{}' {}": '{2}的“{1}”',
  "a new line or ';' after {}": '{1}之后的换行或“;”',
  "after '{}'": '“{1}”之后',
  "after '{}['": '“{1}[”之后',
  "'=' after '{}.{}'": '“{1}.{2}”之后的“=”',
  "'def', 'over' or 'class'": '“def”、“over”或“class”',
  '@file@ or </Prim>': ' @文件@ 或 </Prim>',
  "a metadata key or ')'": '元数据的键或“)”',
  "')' after metadata": '元数据之后的“)”',
  "after the metadata key '{}'": '元数据的键“{1}”之后',
  'a value of type {}': '类型为 {1} 的值',
  'public or private': ' public 或 private',
  'a text in quotes': '加引号的文本',
  'a name in quotes': '加引号的名称',
  'a {} in quotes': '加引号的值（{1}）',
  'before pairs': '成对的值之前',
  'between the parts of a pair': '一对值的两部分之间',
  "',' or '}' after a pair": '一对值之后的“,”或“}”',
  'before variant selections': '变体选择之前',
  'the name of a variant set': '变体集的名称',
  'the name of a variant': '变体的名称',
  "the selection of '{}'": '“{1}”的选择',
  "offset, scale, customData or ')'": ' offset、scale、customData 或“)”',
  "after 'reorder rootPrims'": '“reorder rootPrims”之后',
  'names in the list before this': '在此之前列表中的名称',
  'a prim type': ' prim 类型',
  'the name of a prim in quotes': '加引号的 prim 名称',
  'before the contents of {}': ' {1} 的内容之前',
  "'}' after the contents of {}": ' {1} 的内容之后的“}”',
  "after the variant set '{}'": '变体集“{1}”之后',
  "before the variants of '{}'": '“{1}”的变体之前',
  "the name of a variant of '{}' or '}'": '“{1}”的变体名称或“}”',
  "a property or '}' in {}": ' {1} 中的属性或“}”',
  'the name of a relationship': '关系的名称',
  "the relationship '{}'": '关系“{1}”',
  'the name of a {} attribute': ' {1} 属性的名称',
  "the attribute '{}'": '属性“{1}”',
  'timeSamples, connect or spline': ' timeSamples、connect 或 spline',
  "'.connect' after a list qualifier": '列表限定词之后的“.connect”',
  'before time samples': '时间样本之前',
  'after the time {}': '时间 {1} 之后',
  "',' or '}' after a time sample": '时间样本之后的“,”或“}”',
  'a whole number': '整数',
  'an asset path (@…@)': '资源路径（@…@）',
  'an asset path in quotes': '引号中的资源路径',
  'this asset path has a control character': '此资源路径含有控制字符',
  'a path (<…>)': '路径（<…>）',
  'before a list': '列表之前',
  "',' or ']' in a list": '列表中的“,”或“]”',
  'before a value with {} numbers': '含 {1} 个数的值之前',
  'between the {} parts of a value': '值的 {1} 个部分之间',
  'after the {} parts of a value': '值的 {1} 个部分之后',
  'before a dictionary': '字典之前',
  'the name of a dictionary entry': '字典条目的名称',
  "the dictionary entry '{}'": '字典条目“{1}”',
  'a closing bracket': '右括号',
  'before a spline': '样条之前',
  "',' or '}' in a spline": '样条中的“,”或“}”',
  'before the kind of extrapolation': '外推方式之前',
  'none, held, linear, sloped or loop': ' none、held、linear、sloped 或 loop',
  'before a slope': '斜率之前',
  'after a slope': '斜率之后',
  'repeat, reset or oscillate': ' repeat、reset 或 oscillate',
  "after 'loop'": '“loop”之后',
  'before the five numbers of a loop': '循环的五个数之前',
  'between the five numbers of a loop': '循环的五个数之间',
  'after the five numbers of a loop': '循环的五个数之后',
  "'pre', 'post' or a dictionary": '“pre”、“post”或字典',
  'none, held, linear or curve': ' none、held、linear 或 curve',
  'before a tangent': '切线之前',
  "')' after the width and the slope of a tangent": '切线的宽度和斜率之后的“)”',
  'after a tangent': '切线之后',

  // The text of a layer: what is wrong with it
  "the file does not begin with '#usda 1.0', so it is not USD text": '文件不以“#usda 1.0”开头，因此不是 USD 文本',
  'is USD text of version {}.{}; only 1.x is read': '这是版本 {1}.{2} 的 USD 文本；只能读取 1.x',
  'this text is not UTF-8; save the file as UTF-8': '此文本不是 UTF-8；请将文件保存为 UTF-8',
  'the comment that begins here is not closed with */': '从这里开始的注释没有以 */ 结束',
  'the exponent of this number has no digits': '此数的指数没有数字',
  'the string that begins here is not closed': '从这里开始的字符串没有结束',
  'the string that begins here is not closed on its line': '从这里开始的字符串没有在本行结束',
  'the asset path that begins here is not closed with {} on its line': '从这里开始的资源路径没有在本行以 {1} 结束',
  'the path that begins here is not closed with > on its line': '从这里开始的路径没有在本行以 > 结束',
  'an item of this list is there twice': '此列表中有重复的项',
  "'{}' is no list, which could be edited": '“{1}”不是可以编辑的列表',
  "'{}' is a word of the language, no metadata key": '“{1}”是语言的关键字，不是元数据的键',
  "'{}' is a word of the language, no prim type": '“{1}”是语言的关键字，不是 prim 类型',
  "'{}' is a word of the language, no type": '“{1}”是语言的关键字，不是类型',
  "'{}' is not public or private": '“{1}”不是 public 或 private',
  'a variant selection is a string, not a {}': '变体选择应为 string，而不是 {1}',
  '<{}> is not the path of a prim': '<{1}> 不是 prim 的路径',
  '<{}> is not the path of a prim or a property': '<{1}> 不是 prim 或属性的路径',
  '<{}> is not the path of a prim from the root': '<{1}> 不是从根开始的 prim 路径',
  'this asset path is empty': '此资源路径为空',
  "'{}' is not offset, scale or customData": '“{1}”不是 offset、scale 或 customData',
  'prims are nested more than {} deep': 'prim 嵌套超过 {1} 层',
  'variant sets are nested more than {} deep': '变体集嵌套超过 {1} 层',
  'dictionaries are nested more than {} deep': '字典嵌套超过 {1} 层',
  'brackets are nested more than {} deep': '括号嵌套超过 {1} 层',
  "'{}' is not a prim name": '“{1}”不是 prim 的名称',
  'there is already a prim {}': '已有 prim {1}',
  "'{}' is already an attribute of {}": '“{1}”已是 {2} 的属性',
  "'{}' is already a relationship of {}": '“{1}”已是 {2} 的关系',
  "'{}' is already of type {}, not {}": '“{1}”的类型已是 {2}，不是 {3}',
  "'{}' is uniform in one statement and not in another": '“{1}”在一条语句中是 uniform，在另一条中却不是',
  "'.{}' is not .timeSamples, .connect or .spline": '“.{1}”不是 .timeSamples、.connect 或 .spline',
  '{} is not a time': '{1} 不是时间',
  '{} is not a whole number from {} to {}': '{1} 不是 {2} 到 {3} 之间的整数',
  "'{}' is not true, false, 0 or 1": '“{1}”不是 true、false、0 或 1',
  '{} does not fit {}': '{1} 超出 {2} 的范围',
  'a spline is of type double, float or half, not {}': '样条的类型是 double、float 或 half，而不是 {1}',
  "'{}' is not bezier, hermite, pre, post, loop or the time of a knot":
    '“{1}”不是 bezier、hermite、pre、post、loop，也不是结点的时间',
  "'{}' is not none, held, linear, sloped or loop": '“{1}”不是 none、held、linear、sloped 或 loop',
  "'loop {}' is not loop repeat, loop reset or loop oscillate":
    '“loop {1}”不是 loop repeat、loop reset 或 loop oscillate',
  'how often a spline is looped, is a whole number': '样条循环的次数须为整数',
  "'{}' is not none, held, linear or curve": '“{1}”不是 none、held、linear 或 curve',
  'the width of a tangent is {}; it cannot be negative': '切线的宽度为 {1}；它不能为负',
  "'{}' is not custom or autoEase": '“{1}”不是 custom 或 autoEase',
  '{} cannot be in a spline': '{1} 不能出现在样条中',

  // Packages
  '{} files: {}': '{1} 个文件：{2}',
  'the package holds no USD layer ({})': '包中没有 USD 图层（{1}）',
  'packages are nested more than {} deep in it': '其中的包嵌套超过 {1} 层',
  '{} in it is compressed (method {}), which usdz does not allow; pack it with usdzip':
    '其中的 {1} 经过压缩（方法 {2}），usdz 不允许压缩；请用 usdzip 打包',
  '{} in it has two different sizes': '其中的 {1} 有两个不同的大小',
  '{} in it ends at byte {} of {}; it is cut off': '其中的 {1} 结束于字节 {2}，而文件只有 {3} 字节；它被截断',

  // Crate files: their bytes
  '{} lies at byte {}, before the file': '{1}位于字节 {2}，在文件之前',
  '{} takes {} bytes from byte {}': '{1}从字节 {3} 起占 {2} 字节',
  '{}, and the file ends at byte {}; it is cut off or damaged': '{1}，而文件在字节 {2} 处结束；它被截断或已损坏',
  'a crate file of {} is read to {}': '{1} 的 crate 文件至多用 {2} 读取',
  '{} would take {} where {} are left: {}; split it into several layers':
    '{1}需占 {2}，而只剩 {3}：{4}；请把它拆分为多个图层',
  '{} is {}, which no file has': '{1}为 {2}，没有这样的文件',
  'the number of {}': '{1}的数目',
  'it says {} {}, for which the {} bytes that are left cannot hold room': '它称有 {1} 个{2}，而剩余的 {3} 字节容纳不下',
  'it says {} {}, which {} compressed bytes cannot hold': '它称有 {1} 个{2}，而 {3} 个压缩字节容纳不下',
  'it says {} {}': '它称有 {1} 个{2}',
  'of {} {} the compressed data holds {}': '在 {1} 个{2}中，压缩数据只含 {3} 个',
  'bytes of compressed {}': '压缩的{1}字节',
  'compressed data': '压缩数据',
  'compressed data of no bytes': '压缩数据没有字节',
  'the size of a compressed chunk': '压缩块的大小',
  'a compressed chunk says {} bytes, past its end': '压缩块称有 {1} 字节，超出其结尾',
  'compressed data ends in the middle of a length': '压缩数据在长度中途结束',
  'compressed data has {} bytes that do not fit': '压缩数据有 {1} 字节放不下',
  'compressed data ends in the middle of a match': '压缩数据在匹配中途结束',
  'compressed data repeats {} bytes from {} before, which it has not':
    '压缩数据要重复前 {2} 字节处的 {1} 字节，而没有这些字节',
  'is a crate file of version {}.{}.{}; {}; {}': '这是版本 {1}.{2}.{3} 的 crate 文件；{4}；{5}',
  '0.{} to 0.{} are read': '可读取 0.{1} 到 0.{2}',
  'write it anew with a present OpenUSD: usdcat in.usdc -o out.usdc':
    '请用当前的 OpenUSD 重新写出：usdcat in.usdc -o out.usdc',
  'write it as text: usdcat in.usdc -o out.usda': '请写为文本：usdcat in.usdc -o out.usda',

  // Crate files: their sections
  'the header': '文件头',
  'the place of the table of contents': '目录的位置',
  'table of contents': '目录',
  sections: '段',
  'it says {} sections; a crate file has {}': '它称有 {1} 个段；crate 文件有 {2} 个',
  'the name of a section': '段的名称',
  'the place of section {}': '段“{1}”的位置',
  'the size of section {}': '段“{1}”的大小',
  'section {}': '段“{1}”',
  'there is no section {}': '没有段“{1}”',
  'the number of tokens': '标记的数目',
  'the size of the tokens': '标记的大小',
  'bytes of compressed tokens': '压缩的标记字节',
  'the tokens': '标记',
  'it says {} bytes of tokens, which {} compressed bytes cannot hold':
    '它称有 {1} 字节的标记，而 {2} 个压缩字节容纳不下',
  'it says {} tokens in {} bytes': '它称 {2} 字节中有 {1} 个标记',
  '{} tokens': '{1} 个标记',
  'of {} tokens there are {}': '{1} 个标记中只有 {2} 个',
  'token {} is not UTF-8': '标记 {1} 不是 UTF-8',
  'an element of a path is token {} of {}': '路径的一个元素是标记 {1}，而标记有 {2} 个',
  strings: '字符串',
  '{} strings': '{1} 个字符串',
  'string {} is token {} of {}': '字符串 {1} 是标记 {2}，而标记有 {3} 个',
  fields: '字段',
  'names of fields': '字段名称',
  'the name of field {} is token {} of {}': '字段 {1} 的名称是标记 {2}，而标记有 {3} 个',
  'bytes of compressed values': '压缩的值字节',
  'the values of fields': '字段的值',
  'the values of {} fields': '{1} 个字段的值',
  'the values of {} fields take {} bytes, not {}': '{1} 个字段的值占 {2} 字节，而不是 {3} 字节',
  'fields of sets': '字段集的字段',
  'the number of paths': '路径的数目',
  'the number of encoded paths': '已编码路径的数目',
  'it says {} encoded paths of {}': '它称 {2} 条路径中有 {1} 条已编码',
  '{} paths': '{1} 条路径',
  'a path': '路径',
  'indices of paths': '路径索引',
  'elements of paths': '路径元素',
  'jumps between paths': '路径间的跳转',
  'a jump between paths leads to path {} of {}, or round in a circle':
    '路径间的跳转指向路径 {1}，而路径有 {2} 条，或形成循环',
  'a path has index {} of {}': '一条路径的索引为 {1}，而路径有 {2} 条',
  'two paths have index {}': '两条路径的索引都是 {1}',
  'the jump after path {} is {}': '路径 {1} 之后的跳转为 {2}',
  'paths are nested more than {} deep': '路径嵌套超过 {1} 层',
  specs: '规格',
  'paths of specs': '规格的路径',
  'field sets of specs': '规格的字段集',
  'types of specs': '规格的类型',

  // Crate files: their specs and fields
  'there is no spec of the layer itself': '没有图层本身的规格',
  'there is a spec of this path, which is in no list of what is in its parent': '此路径有规格，但其上级的列表中没有它',
  'its specifier is not def, over or class': '其说明符不是 def、over 或 class',
  "'{}' is not a property name": '“{1}”不是属性的名称',
  "it lists '{}', of which there is no spec, or lists it twice": '它列出了“{1}”，但没有其规格，或重复列出',
  'the attribute has no type': '属性没有类型',
  'spec {} is of path {}, which is none': '规格 {1} 属于路径 {2}，而没有这条路径',
  'there are two specs of {}': '{1} 有两个规格',
  'of its fields, from {} on, one is field {} of {}': '在其从 {1} 起的字段中，有一个是字段 {2}，而字段有 {3} 个',
  'it has this field twice': '它有重复的此字段',
  'its {} is of kind {}, not {}': '其 {1} 的类型是 {2}，不是 {3}',
  'its permission is {}': '其 permission 为 {1}',
  'its metadata {} is of kind {}': '其元数据 {1} 的类型是 {2}',
  'its {} hold a {}, not only strings': '其 {1} 含有 {2}，不全是字符串',
  'unregistered metadata of kind {}': '类型为 {1} 的未注册元数据',

  // Crate files: their values
  'an array edit (crate 0.14) is not read; flatten it: usdcat --flatten in.usdc -o out.usda':
    '不支持读取数组编辑（crate 0.14）；请将其展平：usdcat --flatten in.usdc -o out.usda',
  'there is no token {}; there are {}': '没有标记 {1}；标记有 {2} 个',
  'there is no string {}; there are {}': '没有字符串 {1}；字符串有 {2} 个',
  'there is no path {}; there are {}': '没有路径 {1}；路径有 {2} 条',
  'there is no type {}': '没有类型 {1}',
  'there are no arrays of type {}': '没有类型 {1} 的数组',
  'a value': '值',
  'the place of a value': '值的位置',
  'a value of kind {} stands where none can': '类型为 {1} 的值出现在不该有值的地方',
  'values are nested more than {} deep': '值嵌套超过 {1} 层',
  'a token': '标记',
  'an asset': '资源',
  'an offset': '偏移',
  'a scale': '缩放',
  'an integer of 64 bits': '64 位整数',
  integers: '整数',
  'whole numbers': '整数',
  'items of a list': '列表项',
  'a list of {} items': '含 {1} 项的列表',
  'a list op': '列表操作',
  'a dictionary': '字典',
  'entries of a dictionary': '字典条目',
  'the key of a dictionary entry': '字典条目的键',
  'an array of {} tuples': '含 {1} 个元组的数组',
  'an array of {} texts': '含 {1} 个文本的数组',
  'an array of {} numbers': '含 {1} 个数的数组',
  'the rank of an array': '数组的秩',
  'the length of an array': '数组的长度',
  'an array has length {}': '数组的长度为 {1}',
  'an array of {} says it is compressed': '{1} 数组称其经过压缩',
  'how numbers are compressed': '数的压缩方式',
  'numbers are compressed in an unknown way ({})': '数以未知的方式压缩（{1}）',
  'the size of a table of numbers': '数表的大小',
  'places in a table': '表中位置',
  'number {} of an array is at place {} of a table of {}': '数组的第 {1} 个数位于表的第 {2} 处，而表有 {3} 个数',
  'the place of samples': '样本的位置',
  'values of samples': '样本值',
  'there are {} samples at {} times': '{2} 个时刻有 {1} 个样本',
  '{} samples': '{1} 个样本',
  'the times of samples are of kind {}, not numbers': '样本时间的类型是 {1}，不是数',
  'sample {} is at the time {}, not after {}': '样本 {1} 的时间为 {2}，须晚于：{3}',
  'all before': '此前所有样本',
  'a spline': '样条',
  'bytes of a spline': '样条字节',
  'a spline has {} bytes, and what it says takes {}': '样条有 {1} 字节，而其内容占 {2} 字节',
  'a spline extrapolates in way {}': '样条的外推方式为 {1}，无法识别',
  'a slope': '斜率',
  'the start of a loop': '循环的开始',
  'the end of a loop': '循环的结束',
  'the loops before': '之前的循环次数',
  'the loops after': '之后的循环次数',
  'the offset of a loop': '循环的偏移',
  'a knot': '结点',
  'knots with data': '带数据的结点',
  'data of knots': '结点的数据',
  'the time of a knot': '结点的时间',
  'the number of knots': '结点的数目',
  '{} knots': '{1} 个结点',
  'knot {} of a spline is at the time {}, not after those before it': '样条的结点 {1} 的时间为 {2}，不晚于之前的结点',
  "a knot has tangents in Maya's form, which is not read; write it as text: usdcat":
    '结点的切线采用 Maya 的形式，不支持读取；请用 usdcat 将其写为文本',
  'the width of a tangent': '切线的宽度',
  'how tangents are made': '切线的生成方式',
  'tangents are made in way {}': '切线的生成方式为 {1}，无法识别',
  // ———— glTF ————
  // Parts of a file, as places
  'bufferView {}': '缓冲区视图 {1}',
  'buffer {}': '缓冲区 {1}',
  'accessor {}': '访问器 {1}',
  '{}, sparse': '{1}，稀疏部分',
  'image {}': '图像 {1}',
  'texture {}': '纹理 {1}',
  'mesh {}': '网格 {1}',
  'mesh {}, a variant': '网格 {1}，其变体',
  'node {}': '节点 {1}',
  'node {}, its instances': '节点 {1}，其实例',
  'a node': '某节点',
  'skin {}': '蒙皮 {1}',
  'scene {}': '场景 {1}',
  'the default scene': '默认场景',
  'animation {}': '动画 {1}',
  'animation {}, {}.{}': '动画 {1}，{2}.{3}',
  'without a name': '未命名',

  // The file as a whole
  '{} of {}: the file is cut off; copy or export it again': '{1}，而应有 {2}：文件被截断；请重新复制或导出',
  'holds {} of {}: the file is cut off; copy or export it again': '只有 {1}，而应有 {2}：文件被截断；请重新复制或导出',
  'GLB version {}; only 2 is read, export it as glTF 2.0': 'GLB 版本 {1}；只支持版本 2，请导出为 glTF 2.0',
  'the interpolation {} of {} of {} samplers is not LINEAR, STEP or CUBICSPLINE; it is taken as LINEAR':
    '{3} 个采样器中有 {2} 个的插值 {1} 不是 LINEAR、STEP 或 CUBICSPLINE；按 LINEAR 处理',
  'glTF {}; only 2.0 is read, export it as 2.0': 'glTF {1}；只支持 2.0，请导出为 2.0',
  'the GLB has no JSON chunk; export it again': 'GLB 中没有 JSON 数据块；请重新导出',
  'a chunk of {} at byte {} runs past the end; export it again':
    '字节 {2} 处大小为 {1} 的数据块超出了文件结尾；请重新导出',
  'the JSON is damaged or cut off ({}); copy or export it again': 'JSON 已损坏或被截断（{1}）；请重新复制或导出',
  'not a glTF: the JSON has no "asset"': '不是 glTF：JSON 中没有“asset”',
  'not a valid glTF ({}); export it again': '不是有效的 glTF（{1}）；请重新导出',
  'there is no file {}; put it beside the scene': '没有文件 {1}；请把它放在场景旁边',
  'its data URI cannot be decoded ({})': '其 data URI 无法解码（{1}）',
  'it needs the extension {}, which is not read; export it without': '它需要扩展 {1}，而此扩展不受支持；请不用它导出',
  'the extension {} is left out{}': '扩展 {1} 已去掉{2}',
  '; what uses it is shown without its picture or colour': '；用到它的内容显示时没有其图像或颜色',

  // Requirements on its parts
  'is {}, not {}': '现为 {1}，而应为{2}',
  'is missing, not {}': '缺失，而应有{1}',
  'a finite number': '有限的数',
  'a whole number from 0': '不小于 0 的整数',
  'a text': '文本',
  'an object': '对象',
  'an array': '数组',
  '{} numbers': ' {1} 个数',
  'a picture: it needs uri or bufferView': '图像：须有 uri 或 bufferView',
  'refers to {} {}, of which there are {}; export it again': '引用的编号超出范围：{1} {2}，而总数为 {3}；请重新导出',
  'refers to buffer {}': '引用了不存在的缓冲区 {1}',
  'refers to bufferView {}': '引用了不存在的缓冲区视图 {1}',
  'refers to accessor {}': '引用了不存在的访问器 {1}',
  'wants bytes {} to {} of {}; the file is damaged, export it again':
    '需要字节 {1} 至 {2}，而总共只有 {3} 字节；文件已损坏，请重新导出',
  '{} of {}, component type {}': '{1} 个 {2}，分量类型为 {3}',
  '{} changed values of {}': '更改了 {2} 个值中的 {1} 个',
  'unpack to {}, more than {}': '解压后为 {1}，超过 {2}',
  'has two parents, nodes {} and {}; export it again': '有两个父节点：节点 {1} 和 {2}；请重新导出',
  'is nested more than {} deep, or in itself; flatten the hierarchy': '嵌套超过 {1} 层，或嵌套在自身之中；请减少层级',

  // Compressed geometry
  'its compressed data {}; export it again, or without compression': '其压缩数据有误：{1}；请重新导出，或不用压缩导出',
  'with it the file unpacks to more than {}; export it in parts': '连同它，文件解压后超过 {1}；请分成几部分导出',
  'unpacks to {} bytes, not to {}': '解压后为 {1} 字节，而不是 {2} 字节',
  'is compressed as triangles, but drawn in mode {}': '按三角形压缩，却以模式 {1} 绘制',
  'holds {} values for accessor {}, which has {}': '为访问器 {2} 提供了 {1} 个值，而它有 {3} 个',
  'has {} numbers in each {}, not {}': '每个 {2} 有 {1} 个数，而不是 {3}',
  'wants more memory than its size accounts for': '所需内存超出其大小应有的范围',
  'cannot be decoded ({})': '无法解码（{1}）',
  'no reason is given': '未给出原因',
  'does not begin with DRACO': '开头不是 DRACO',
  'has bitstream version {}.{}; glTF takes 2.2': '位流版本为 {1}.{2}；glTF 要求 2.2',
  'holds geometry of kind {}, not a mesh (1)': '几何体的种类为 {1}，而不是网格（1）',
  'carries metadata of its own, which is not read': '带有自己的元数据，这不受支持',
  'claims {} triangles in {} bytes': '声称以 {2} 字节存有 {1} 个三角形',
  'its accessor has component type {}': '其访问器的分量类型为 {1}',
  'has no attribute {}': '没有属性 {1}',
  'attribute {} cannot be read': '无法读取属性 {1}',
  'has the unknown mode {}': '模式 {1} 未知',
  'has the unknown filter {}': '过滤器 {1} 未知',
  'has count {}': '个数为 {1}',
  'has {} corners of triangles, not a multiple of 3': '有 {1} 个三角形的角，不是 3 的倍数',
  'has elements of {} bytes in mode {}': '模式 {2} 的元素为 {1} 字节',
  'has elements of {} bytes with filter {}': '过滤器 {2} 的元素为 {1} 字节',
  'claims {} elements in {} bytes': '声称以 {2} 字节存有 {1} 个元素',
  'holds {} bytes more than it needs': '比所需的多 {1} 字节',
  'begins with byte {}, not with 160 or 161': '首字节为 {1}，而不是 160 或 161',
  'begins with byte {}, not with {}': '首字节为 {1}，而不是 {2}',
  'of {} bytes is shorter than its own end': '共 {1} 字节，比自身的尾部还短',
  'differences channel {} in an unknown way': '通道 {1} 的差分方式未知',
  'a number of more than 5 bytes ends at byte {}': '一个超过 5 字节的数止于字节 {1}',
  'wants {} more bytes at byte {}, but the data ends at {}': '在字节 {2} 处还需要 {1} 字节，而数据止于 {3}',
  'has {} bytes, too few for {} triangles': '有 {1} 字节，不足以容纳 {2} 个三角形',
  'has {} bytes, too few for {} indices': '有 {1} 字节，不足以容纳 {2} 个索引',

  // Meshes, joints and instances
  'has no positions': '没有顶点位置',
  'mode {} does not exist': '不存在 {1} 号模式',
  '{}; that part is left out': '{1}；已将该部分去掉',
  'has single-sided and double-sided materials; all of it is shown double-sided':
    '既有单面材质也有双面材质；全部按双面显示',
  'a triangle': '某个三角形',
  'a point or line': '某个点或某条线',
  '{} wants vertex {} of {}; the file is damaged, export it again':
    '{1}用到顶点 {2}，而顶点只有 {3} 个；文件已损坏，请重新导出',
  'points and lines have no width in glTF; points are shown as spheres {} m across and lines as tubes {} m wide, by the size of the scene, and thinner in small meshes':
    'glTF 的点和线没有宽度；按场景大小将点显示为直径 {1} 米的球，将线显示为宽 {2} 米的管，小网格中的更细',
  'it has {} pieces of lines; one in {} is drawn, since their tubes have at most {} points':
    '有 {1} 段线；其管最多有 {3} 个点，因此每 {2} 段绘制一段',
  '{} has {} values for {} vertices; export it again': '{1} 有 {2} 个值，而顶点有 {3} 个；请重新导出',
  'the opacity of its vertex colours is left out': '其顶点颜色的不透明度已去掉',
  'a vertex follows joint {} of {}; the file is damaged, export it again':
    '某个顶点跟随关节 {1}，而关节只有 {2} 个；文件已损坏，请重新导出',
  '{} inverse bind matrices for {} joints; export it again': '{1} 个逆绑定矩阵，而关节有 {2} 个；请重新导出',
  '{} of its instances are left out': '{1} 已从其实例中去掉',
  'has {} instances; at most {} are read': '有 {1} 个实例；至多读取 {2} 个',
  '{} of its instances has {} of {}, for {}; export it again':
    '{1} 在其实例中有 {2} 个 {3}，而实例有 {4} 个；请重新导出',
  'its instances all follow the same joints, so that they are in one place; one is shown':
    '其实例都跟随相同的关节，因而位于同一处；只显示一个',
  'more than {}; export fewer': '超过{1}；请减少导出的内容',
  '{} objects with all copies of its meshes': ' {1} 个物体，其网格的所有副本计算在内',
  '{} vertices with all sizes of its meshes': ' {1} 个顶点，其网格的所有大小计算在内',

  // Materials
  'its {} has no picture that is read; shown without it': '其 {1} 没有能读取的图像；显示时不用它',
  'its {} has its own uv set or transform; that of the {} is used for both':
    '其{1}有自己的纹理坐标或变换；两者都采用{2}的',
  'base colour texture': '基色纹理',
  'emissive texture': '自发光纹理',
  'normal texture': '法线纹理',
  'metallic-roughness texture': '金属度与粗糙度纹理',
  '{} more': '另有 {1} 个',
  unlit: '无光照',
  'strength or colour of reflection': '反射的强度或颜色',
  clearcoat: '清漆',
  'specular texture': '镜面反射纹理',
  'specular colour texture': '镜面反射颜色纹理',
  'clearcoat texture': '清漆纹理',
  'clearcoat roughness texture': '清漆粗糙度纹理',
  'clearcoat normal texture': '清漆法线纹理',
  'diffuse texture': '漫反射纹理',
  'specular-glossiness texture': '镜面反射-光泽度纹理',
  'UsdPreviewSurface has no {}; write glTF to keep that': 'UsdPreviewSurface 没有{1}；要保留它，请写为 glTF',
  'tinted reflection of what is partly metal': '部分为金属的表面的有色反射',
  'texture of the strength of reflection': '反射强度的纹理',
  'normal map of the clearcoat': '清漆的法线贴图',
  sheen: '绒光',
  anisotropy: '各向异性',
  Anisotropy: '各向异性',
  'Fine parallel grooves, as of brushed metal, which widen reflections along them.':
    '细密的平行沟纹，如拉丝金属，使反射沿沟纹方向变宽。',
  'Direction of the anisotropy': '各向异性的方向',
  'anisotropy texture': '各向异性纹理',
  Sheen: '绒光',
  'Upright fibres over the surface, as of velvet and dust, which reflect at grazing angles.':
    '表面上直立的细纤维，如天鹅绒和灰尘，在掠射角反射光。',
  'Colour of the sheen': '绒光颜色',
  'Roughness of the sheen': '绒光的粗糙度',
  'sheen colour texture': '绒光颜色纹理',
  'sheen roughness texture': '绒光粗糙度纹理',
  'unlit surface: it emits its colour through the tone curve': '无光照表面：其颜色经色调曲线发出',
  'Index of refraction': '折射率',
  'Determines how much is reflected, and how glass refracts: 1.33 is water, 1.5 glass, 2.42 diamond.':
    '决定反射多少以及玻璃如何折射：1.33 是水，1.5 是玻璃，2.42 是钻石。',
  Clearcoat: '清漆',
  'A clear varnish over everything else.': '覆盖在其他一切之上的透明清漆。',
  'Roughness of the clearcoat': '清漆的粗糙度',
  'transmission texture': '透射纹理',
  'thickness texture': '厚度纹理',
  transmission: '透射',
  'transmission, volume or dispersion': '透射、体积或色散',
  Transmission: '透射',
  'Clear glass: what is not reflected passes, tinted by the colour.': '透明玻璃：未被反射的光穿过，并染上颜色。',
  '0 is a thin sheet; a body refracts and absorbs. The fast renderer refracts by this thickness, the reference renderer by the shape.':
    '0 是薄片；实体会折射和吸收。快速渲染器按此厚度折射，参考渲染器按形状折射。',
  'Colour inside': '内部颜色',
  'What white light becomes after the absorption length.': '白光经过吸收长度后的颜色。',
  'Absorption length': '吸收长度',
  Dispersion: '色散',
  '20 divided by the Abbe number: crown glass has 0.3, diamond 0.36, flint glass 0.55.':
    '20 除以阿贝数：冕牌玻璃为 0.3，钻石为 0.36，火石玻璃为 0.55。',
  'iridescence texture': '虹彩纹理',
  'iridescence thickness texture': '虹彩薄膜厚度纹理',
  iridescence: '虹彩',
  Iridescence: '虹彩',
  'Thickness of the film': '薄膜厚度',
  'Index of refraction of the film': '薄膜折射率',
  "A thin film whose two sides' reflections interfere, as of soap and oil.":
    '两面的反射相互干涉的薄膜，如肥皂膜和油膜。',
  'occlusion texture': '遮蔽纹理',
  'no variant {} of its materials; {}': '材质没有变体 {1}；{2}',
  'the file has none': '文件中一个也没有',

  // Animations, cameras and lights
  'no animation {}; {}': '没有动画 {1}；{2}',
  'there are {}': '现有 {1}',
  'there is none': '一个也没有',
  '{} animations ({}); {} is shown': '{1} 个动画（{2}）；显示的是 {3}',
  'this kind of animation is not read; it is left out': '不支持这种动画；已将其去掉',
  'has no keys; export it again': '没有关键帧；请重新导出',
  '{} values for {} keys, {} are needed; export it again': '{1} 个值对应 {2} 个关键帧，需要 {3} 个；请重新导出',
  'key {} is at {} s after {} s; keys must rise': '关键帧 {1} 在 {2} s，而前一个在 {3} s；关键帧的时刻必须递增',
  'moves too wildly between its {} keys to be followed: about {} samples would be needed, {} are used, and paths are off by up to {} m; export more keys':
    '在其 {1} 个关键帧之间运动过于剧烈，无法跟随：约需 {2} 个样本，实际用 {3} 个，路径误差至多 {4} m；请导出更多关键帧',
  'jumps {} times (first at {} s); each jump is shown as a ramp of at most 1 ms, and may be faster than light':
    '跳变 {1} 次（首次在 {2} s）；每次跳变显示为至多 1 ms 的渐变，可能超过光速',
  'bends too much to hold in {}; it is sampled at {} times only': '变形太复杂，{1} 容纳不下；只在 {2} 个时刻取样',
  'an orthographic camera is not read; it is left out': '不支持正交相机；已将其去掉',
  'its field of view is {} rad; it is left out': '其视场角为 {1} rad；已将其去掉',
  'its range of {} m is left out: light goes on for ever': '其作用范围 {1} m 已去掉：光会一直传播下去',
  'a turning sun is held where it starts': '转动的太阳固定在起始方向',
  '{}; its light is taken for daylight': '{1}；其光按日光处理',

  // Losses on export
  'glTF has no light from a sky; it is left out': 'glTF 没有天空的光；已将其去掉',
  'its {} is lost: lights of glTF are points{}': '其{1}已丢失：glTF 的灯是点光源{2}',
  'shape, a {},': '形状（{1}）',
  'radius of {} m': '半径（{1} m）',
  ' with a cone': '，带有光锥',
  'its spectrum is lost: a table of it is written beside USD alone': '其光谱已丢失：光谱表只随 USD 写出',
  'its measured reflectance is lost, but for its colour and its means of ultraviolet and infrared: a table of it is written beside USD alone':
    '其实测反射率已丢失，只保留颜色以及紫外与红外的平均值：反射率表只随 USD 写出',
  'its normals are {} times as steep along u and {} times along v; the first is taken for both':
    '其法线的陡度沿 u 为 {1} 倍，沿 v 为 {2} 倍；两者都取前者',
  'its base colour {} is cut to 0 … 1': '其基色 {1} 被限制到 0 … 1',
  'its linear colours are taken as sRGB there': '其线性颜色在写出的文件中被当作 sRGB',
  'its {} points are sampled at {} times, more than the {} that become morph targets; it is written at rest, as it is at its first':
    '其 {1} 个点有 {2} 个时刻的样本，超过可成为变形目标的 {3} 个；按首个时刻的形状静止写出',
  'the points of its skins at all their times would take {}; they are written at {} % of these times':
    '其蒙皮的点在所有时刻共需 {1}；只写出其中 {2} % 的时刻',
  'its points go along cubics; there they go straight': '其点沿三次曲线运动；在写出的文件中沿直线运动',
  'all times are {} s later: glTF has none before 0': '所有时刻都推后 {1} s：glTF 没有早于 0 的时刻',
  // ———— Other files ————
  // Places in files; the last value may be followed by a message
  'line {}': '行 {1}',
  '{}: line {}': '{1}：行 {2}',
  '{}: after line {}': '{1}：在此行之后：{2}',
  'byte {}': '字节 {1}',
  '{}: byte {}': '{1}：字节 {2}',
  '{} bytes': '{1} 字节',
  'material {}': '材质 {1}',
  '{}, material {}': '{1}，材质 {2}',

  // Opening and saving scenes
  'no such file': '没有这个文件',
  'no such file; there is {}': '没有这个文件；现有 {1}',
  'no such file; check its name, and where it is': '没有这个文件；请检查其名称和位置',
  'the file is empty (0 bytes); export or copy it again': '文件是空的（0 字节）；请重新导出或复制',
  'cannot be read as {}: {}; the file may be damaged, export it again':
    '无法作为 {1} 读取：{2}；文件可能已损坏，请重新导出',
  'this is a project, not a scene; {}': '这是项目，不是场景；{1}',
  'render, simulate and graph check take it, and the page opens it at ?project=…':
    '它可用于 render、simulate 和 graph check，页面用 ?project=… 打开它',
  '.{} is not a scene format that can be opened; {} can': '.{1} 不是可打开的场景格式；可打开的有 {2}',
  'the name has no extension; {} can be opened': '文件名没有扩展名；可打开的有 {1}',
  'with this file the scene takes {}, more than the {} that are read; use smaller textures or fewer samples':
    '加上这个文件，场景占 {1}，超过可读取的 {2}；请用更小的纹理或更少的样本',
  '.{} is not a scene format that can be written; {} can': '.{1} 不是可写出的场景格式；可写出的有 {2}',
  'and {} others like it; the first {} are listed': '另有 {1} 条同类说明；只列出前 {2} 条',
  'there are more of these; the first {} are listed': '还有更多同类说明；只列出前 {1} 条',
  'neither unit nor up axis is written in it; one unit is taken as 1 m, Y as up':
    '其中没有写明单位和朝上的轴；一个单位按 1 m 处理，以 Y 为上',
  'no triangle is in it, so that there is nothing to see': '其中没有三角形，因此什么也看不到',
  'the texture {} is not there (looked for {}); shown without it': '纹理 {1} 不存在（查找过 {2}）；显示时略去它',
  '{}; shown without it': '{1}；显示时略去它',
  'the spectrum {} is not there (looked for {}); {}': '光谱 {1} 不存在（查找过 {2}）；{3}',
  'its light is taken for daylight': '其光按日光处理',
  '{}; the file is damaged, export it again': '{1}；文件已损坏，请重新导出',
  'a line has more than {} bytes; the file is damaged': '有一行超过 {1} 字节；文件已损坏',
  'a number is missing; the file is cut off or damaged': '缺少一个数；文件被截断或已损坏',
  '{} is too large a number': '{1} 这个数太大',

  // What a file cannot hold
  'it is {} pieces that take turns; only the one of the start is written, and there it always is':
    '它由 {1} 个依次出现的部分组成；只写出了起始时的那一个，在那个文件中它始终存在',
  'it lives from {} to {} s; there it always is': '它只存在于 {1} 至 {2} s；在那个文件中它始终存在',
  '{} is sampled from {} to {} s; before and after it rests': '{1}在 {2} 至 {3} s 之间采样；之前和之后静止',
  'its uniform motion': '其匀速运动',
  'its hyperbolic motion': '其匀加速运动',
  'its points go along cubics, which USD does not know: their velocities are written, so that reading with cubic interpolation gives them back; other programs go straight':
    '它的点沿三次曲线运动，USD 没有这种方式：已写出各点的速度，按三次曲线读取即可还原；其他程序按直线运动',
  'OBJ has no motion: it is written where it is at {} s': 'OBJ 不含运动：按它在 {1} s 时的位置写出',
  'OBJ has no place for what the author suggests for viewing': 'OBJ 无处保存作者对观看方式的建议',
  'OBJ has no lights and no cameras; it is left out': 'OBJ 不含灯和相机；已将其去掉',

  // Numbers that are none
  'not a finite number (NaN, or too large)': '不是有限的数（NaN，或太大）',
  'the animation lasts from {} to {} s, which is {}; it is shown from 0 s': '动画从 {1} 到 {2} s，{3}；从 0 s 起显示',
  'where it is, or how it moves, is {}; it is left out': '其位置或运动{1}；已将其去掉',
  'the place of {} of {} points is {}; their {} triangles are left out':
    '{2} 个点中有 {1} 个的位置{3}；已去掉其 {4} 个三角形',
  'some of its normals are {}; they are computed anew': '其中有些法线{1}；已重新计算',
  'some of its texture coordinates are {}; they are taken as 0': '其中有些纹理坐标{1}；已按 0 处理',
  'some of its colours are {}; they are taken as 0': '其中有些颜色{1}；已按 0 处理',
  'a number of the material is {}; it is shown in grey': '材质中有一个数{1}；显示为灰色',
  'a number of it is {}; it is left out': '其中有一个数{1}；已将其去掉',
  '{} is {}, which is not a number from {}; it is left out': '{1} 为 {2}，不是 {3} 之间的数；已将其去掉',
  '0 to 1': '0 至 1',
  '1 to 1e9 K': '1 至 1e9 K',

  // Pictures
  'the picture is empty (0 bytes); copy it again': '图片是空的（0 字节）；请重新复制',
  'the picture is {}; convert it to PNG or JPEG': '图片{1}；请转换为 PNG 或 JPEG',
  'neither PNG nor JPEG': '既不是 PNG，也不是 JPEG',
  '{}, which is not read': '是 {1}，无法读取',
  'it has a picture for each eye: the left one is shown': '它含有两眼各一幅画面：显示左眼的',
  'it is a part of a picture of all directions of {} × {} pixels, of which at most {} Mi are read; make it smaller':
    '它是一幅 {1} × {2} 像素全景的一部分，最多读取 {3} Mi 像素；请缩小它',
  'it does not show all directions: the others are black': '它没有显示所有方向：其余方向为黑色',
  'it is taken for a grid of 3 × 2 faces of a cube, by its aspect ratio, but their edges do not meet: if it is a photograph, it is no panorama':
    '按宽高比它被当作 3 × 2 排列的立方体六个面，但各面的边缘不衔接：如果它是照片，就不是全景图',
  'its frame {} of {} cannot be decoded; ffmpeg says: {}': '第 {1} 帧（共 {2} 帧）无法解码；ffmpeg 报告：{3}',
  'films are decoded by the program ffmpeg, which is not on the PATH. On Debian or Ubuntu: apt-get install -y ffmpeg':
    '影片由程序 ffmpeg 解码，而 PATH 中没有。在 Debian 或 Ubuntu 上：apt-get install -y ffmpeg',
  'this browser gives no canvas of {} × {} pixels': '此浏览器无法提供 {1} × {2} 像素的画布',
  'its frame {} of {} cannot be decoded; the browser says: {}': '第 {1} 帧（共 {2} 帧）无法解码；浏览器报告：{3}',
  'this browser does not decode {}; use another browser, or convert it to H.264 or VP9':
    '此浏览器不能解码 {1}；请换用其他浏览器，或转换为 H.264 或 VP9',
  'its frame {} is no panorama of the size of the first': '第 {1} 帧不是与第一帧同样大小的全景图',
  'it is no film in MP4, QuickTime, Matroska or WebM, or it is damaged; convert it, for instance with ffmpeg':
    '它不是 MP4、QuickTime、Matroska 或 WebM 影片，或已损坏；请转换它，例如用 ffmpeg',
  'there are no pictures in it': '其中没有画面',
  'its colours are of high dynamic range (PQ or HLG), which are not read; convert it to BT.709':
    '其颜色为高动态范围（PQ 或 HLG），不能读取；请转换为 BT.709',
  'it has more than {} frames; cut it into parts': '它超过 {1} 帧；请分割成几段',
  'films are not decoded here; give the frame as a picture': '此处不解码影片；请以图片形式提供该帧',
  'the film has {} × {} pixels, and is no panorama: one is twice as wide as high, or has six square faces, in a strip, a grid or a cross; of a fisheye or a dome master say so in the node Panorama':
    '影片为 {1} × {2} 像素，不是全景影片：全景影片宽为高的两倍，或有六个正方形面，排成一行、网格或十字；若为鱼眼或穹幕母版，请在节点“全景”中说明',
  'the picture is {} × {} pixels, and no panorama': '图片为 {1} × {2} 像素，不是全景图',
  'one is twice as wide as high, or has six square faces: in a strip (6:1 or 1:6), a grid (3:2) or a cross (4:3 or 3:4, with empty corners), or in six files such as px.png, nx.png, py.png, ny.png, pz.png, nz.png':
    '全景图的宽应为高的两倍，或由六个正方形面组成：条状（6:1 或 1:6）、网格（3:2）、十字形（4:3 或 3:4，四角为空），或六个文件，例如 px.png、nx.png、py.png、ny.png、pz.png、nz.png',
  'it is one of the six faces of a cube by its name, but there is no {}; open all six together':
    '按文件名它是立方体六个面之一，但缺少 {1}；请同时打开六个文件',
  'the faces of a cube must be squares of one size and kind, but {} has {} × {} pixels and {} has {} × {}':
    '立方体的各面必须是大小和类型相同的正方形，但 {1} 为 {2} × {3} 像素，而 {4} 为 {5} × {6}',
  'the picture is {} × {} pixels, {}; scale it': '图片为 {1} × {2} 像素，{3}；请缩放',
  '1 to {} a side and at most {} Mi pixels are read': '而可读取的每边为 1 至 {1} 像素，总共至多 {2} Mi 像素',
  '1 to {} a side and at most {} Mi pixels are read of such pictures':
    '而这类图片可读取的每边为 1 至 {1} 像素，总共至多 {2} Mi 像素',
  'the {} is damaged or cut off ({}); export it again': '{1} 已损坏或被截断（{2}）；请重新导出',
  'no end marker': '没有结束标记',
  'no frame header': '没有帧头',
  'a picture of {} × {} has {} bytes of RGBA, not {}': '{1} × {2} 的图片有 {3} 字节的 RGBA，而不是 {4}',

  // PNG
  '{} of {} bytes of pixels': '像素只有 {1} 字节，应为 {2} 字节',
  'wrong check sum of {}': '{1} 的校验和不符',
  'no header': '没有文件头',
  'colour type {} with {} bits': '颜色类型 {1} 配 {2} 位',
  'unknown compression, filter or interlacing': '未知的压缩、滤波或隔行方式',
  'no palette': '没有调色板',
  'row filter {}': '行滤波器 {1}',
  'palette has no colour {}': '调色板没有颜色 {1}',
  'a PNG keyword has 1 … 79 characters, not “{}”': 'PNG 的关键词有 1 … 79 个字符，而不是“{1}”',
  '“{}” cannot stand in the text of a PNG': 'PNG 的文本中不能有“{1}”',

  // OpenEXR
  'not an OpenEXR picture': '不是 OpenEXR 图片',
  'the EXR is damaged or cut off ({}); render or export it again': 'EXR 已损坏或被截断（{1}）；请重新渲染或导出',
  '{} is not read; save it as scan lines with ZIP or no compression':
    '{1}无法读取；请按扫描线保存，用 ZIP 压缩或不压缩',
  'tiled EXR': '分块的 EXR ',
  'deep EXR': '带深度样本的 EXR ',
  'multi-part EXR': '由多个部分组成的 EXR ',
  '{} compression': '{1} 压缩',
  'subsampled channel {}': '降采样的通道 {1} ',
  'an EXR of more than {} channels': '超过 {1} 个通道的 EXR ',
  'an EXR without channels R, G, B or Y is not read; it has {}': '没有通道 R、G、B 或 Y 的 EXR 无法读取；它有 {1}',
  'no {} in the header': '文件头中没有 {1}',
  'data window of {} × {} pixels': '数据窗口为 {1} × {2} 像素',
  'channel {} has no known type': '通道 {1} 的类型未知',
  'too short for {} × {} pixels': '对 {1} × {2} 像素来说太短',
  'a block at row {} of {}': '有一块位于第 {1} 行，共 {2} 行',
  'a block of {} bytes where {} belong': '有一块为 {1} 字节，应为 {2} 字节',
  'a name without an end': '有一个名称没有结尾',
  '{} bytes wanted, {} there': '需要 {1} 字节，只有 {2} 字节',
  'an EXR picture of {} × {} pixels cannot be': 'EXR 图片不能是 {1} × {2} 像素',
  'two EXR channels are named {}': '有两个 EXR 通道名为 {1}',
  'EXR channel {} has {} values for {} × {} pixels': 'EXR 通道 {1} 有 {2} 个值，而像素为 {3} × {4}',

  // Spherical pictures and films
  '{} has {} bytes, less than {}': '{1} 只有 {2} 字节，少于 {3} 字节',
  '{} at byte {} claims {} bytes of the {} that are left': '第 {2} 字节处的 {1} 声称有 {3} 字节，而只剩 {4} 字节',
  '{} at byte {} claims {} bytes, less than its header has': '第 {2} 字节处的 {1} 声称有 {3} 字节，比它的头还少',
  'the header of {} at byte {} is cut off': '第 {2} 字节处 {1} 的头被截断',
  '{} has more than {} boxes': '{1} 的 box 超过 {2} 个',
  'there are more than {} boxes': 'box 超过 {1} 个',
  'there are two moov boxes, at byte {} and {}': '有两个 moov box，分别在第 {1} 和第 {2} 字节',
  'there is no moov box: the film is cut off, or was never finished': '没有 moov box：影片被截断，或没有写完',
  '{} has {}; at most {} are read': '{1} 有 {2}；最多读取 {3}',
  'its parts lead round in circles': '它的各部分循环引用',
  'it is damaged: {}': '它已损坏：{1}',
  '{} ends before its byte {}': '{1} 在其第 {2} 字节之前结束',
  '{} claims {} samples, more than a film can have': '{1} 声称有 {2} 个样本，多于一部影片可能有的',
  'the film is fragmented, which cannot be marked; save it without fragments':
    '影片是分段的（fragmented），无法标记；请保存为不分段的影片',
  'the film has no video track': '影片没有视频轨',
  '{} does not describe its frames': '{1} 没有描述它的帧',
  'a chunk is at byte {}, inside moov or free space': '第 {1} 字节处的数据块在 moov 或空闲空间之内',
  'its box {} holds positions in the file, which are not corrected; save it with moov at its end':
    '它的 box {1} 含有文件中的位置，这些位置不会被修正；请把 moov 保存在文件末尾',
  'a {} picture of {} × {} pixels has no two equal halves': '{2} × {3} 像素的 {1} 图片分不成相等的两半',
  'a crop of {} left, {} right, {} top and {} bottom leaves nothing':
    '左 {1}、右 {2}、上 {3}、下 {4} 的裁剪什么也不留下',
  'an area of {} × {} pixels at ({}, {}) is not in a sphere of {} × {}':
    '位于（{3}，{4}）的 {1} × {2} 像素区域不在 {5} × {6} 的球面图之内',
  '{} is no heading': '{1} 不是方位角',
  '{} is “{}”, which is no number': '{1} 为“{2}”，不是数',
  'the projection {} is not read; equirectangular and cubemap are':
    '投影 {1} 无法读取；可以读取 equirectangular 和 cubemap',
  'the stereo layout {} is not read; mono, top-bottom and left-right are':
    '立体布局 {1} 无法读取；可以读取 mono、top-bottom 和 left-right',
  'a cube map of layout {} with {} pixels of padding is not read; layout 0 without is':
    '布局 {1}、填充 {2} 像素的立方体贴图无法读取；可以读取布局 0 且没有填充的',
  'a cube map in a column is not read; one of 3 × 2 faces is': '排成一列的立方体贴图无法读取；可以读取 3 × 2 排列的',
  'the XML has {} bytes; at most {} are read': 'XML 有 {1} 字节；最多读取 {2} 字节',
  'the XMP chunk at byte {} is damaged': '第 {1} 字节处的 XMP 块已损坏',
  'the compressed XMP is damaged ({})': '压缩的 XMP 已损坏（{1}）',
  'the JPEG is damaged or cut off at byte {}; copy it again': 'JPEG 在第 {1} 字节处损坏或被截断；请重新复制',
  'the PNG is cut off in the chunk at byte {}; copy it again': 'PNG 在第 {1} 字节处的块中被截断；请重新复制',
  'this is no PNG': '这不是 PNG',
  'the picture has {}; at most {} are read': '图片有 {1}；最多读取 {2}',

  // Radiance pictures
  'the Radiance picture is damaged or cut off ({}); export it again': 'Radiance 图片已损坏或被截断（{1}）；请重新导出',
  'a Radiance picture of {} is not read; save it as RGBE': '{1} 的 Radiance 图片无法读取；请保存为 RGBE',
  "a Radiance picture with rows as '{}' is not read; save it with -Y +X":
    '行序为“{1}”的 Radiance 图片无法读取；请以 -Y +X 保存',
  'too short for its size': '数据对其尺寸来说太短',
  'a header without an end': '文件头没有结尾',
  'an exposure that is not above 0': '曝光不大于 0',
  'a run of {} pixels at {} of {}': '第 {2} 个像素（共 {3} 个）处有长 {1} 个像素的游程',
  'a run that does not fit': '有一个游程放不下',
  'its pixels end too early': '像素过早结束',

  // Spectra
  '{}; a spectrum is lines such as "550, 0.87", wavelengths in nm rising':
    '{1}；光谱由“550, 0.87”这样的行组成，波长以 nm 为单位，逐行递增',
  'there are more than {} rows': '超过 {1} 行',
  '"{}" is not two numbers': '“{1}”不是两个数',
  'it has fewer than two rows of a wavelength in nm and a value': '其中由波长（nm）和值组成的行不足两行',
  'all of its values are 0': '所有的值都是 0',
  'its greatest value is {}, and no more than 1 is reflected; divide percents by 100':
    '最大的值是 {1}，而反射不会超过 1；百分数请除以 100',
  '{} nm is not between {} and {} nm': '{1} nm 不在 {2} 至 {3} nm 之间',
  '{} nm comes after {} nm': '{1} nm 排在 {2} nm 之后',
  '{} "{}" is neither a temperature, as "2856 K", nor one of {}; it is left out':
    '{1}“{2}”既不是“2856 K”这样的温度，也不是 {3} 之一；已将其去掉',

  // Fonts
  'the font is no WOFF file': '字体不是 WOFF 文件',
  'the font has cubic outlines, not those of TrueType': '字体的轮廓是三次曲线，不是 TrueType 的轮廓',

  // OBJ
  'it is no Wavefront OBJ: there are more than {} kinds of statements that are not known':
    '这不是 Wavefront OBJ：有超过 {1} 种未知的语句',
  'a face has {} corners; from 3 to {} are read': '有一个面有 {1} 个角；可读取的为 3 至 {2} 个',
  'there are more than {} materials': '材质超过 {1} 个',
  'there are more than {} objects and groups; join some': '物体和组超过 {1} 个；请合并一些',
  'the corner {} names {}; indices count from 1, or back from −1, and there are {} so far':
    '角 {1} 用到{2}；编号从 1 数起，或从 −1 往回数，到此共有 {3} 个',
  'a face names {} of {}; corners that name one that is not there ({}) are shown as without':
    '某个面引用了 {1}（共 {2} 个）；引用不存在者的角（{3} 个）按没有处理',
  'a face names {} of {}; the file is cut off or damaged, export it again':
    '有一个面用到{1}，而总数为 {2}；文件被截断或已损坏，请重新导出',
  'uv {}': '纹理坐标 {1}',
  'normal {}': '法线 {1}',
  '(none)': '(无)',
  '{} not shown ({}, first on this line)': '不显示{1}（{2}，首次出现在此行）',
  'points are': '点',
  'lines are': '线',
  'curves are': '曲线',
  'curved surfaces are': '曲面',
  '{} is not known; lines that begin with it are left out': '未知的 {1}；已去掉以它开头的行',
  'more than {} files of materials are named': '引用的材质文件超过 {1} 个',
  'the materials {} are not there (looked for {}); put them beside it, or open the folder that holds both':
    '材质文件 {1} 不存在（查找过 {2}）；请把它放在旁边，或打开包含二者的文件夹',
  'no such material ({}); it is shown light grey': '没有这种材质（{1}）；显示为浅灰色',
  'no materials were found': '没有找到任何材质',
  '{} {} is not read': '不读取 {1} {2}',
  '{} of it is left out': '已去掉其 {1}',

  // PLY
  'it does not begin with ply; it is no PLY': '它不以 ply 开头；不是 PLY',
  'its header has no end_header; the file is cut off or damaged, copy it again':
    '文件头中没有 end_header；文件被截断或已损坏，请重新复制',
  '{} is not known in a header': '文件头中有未知的 {1}',
  'its header has no format': '文件头中没有 format',
  'the format {} {} is not known': '未知的格式 {1} {2}',
  'an element needs a name and a count, not {} {}': '元素需要名称和数目，而不是 {1} {2}',
  'the element {} comes twice': '元素 {1} 出现了两次',
  'there are more than {} elements': '元素超过 {1} 个',
  'a property comes before the first element': '在第一个元素之前就有属性',
  'an element has more than {} properties': '有一个元素的属性超过 {1} 个',
  'a property has no name': '有一个属性没有名称',
  'the type {} is not known': '未知的类型 {1}',
  'has no element vertex; it holds no mesh': '没有元素 vertex；其中没有网格',
  'its vertices have no x, y and z': '其顶点没有 x、y 和 z',
  'its faces have no list vertex_indices': '其面没有列表 vertex_indices',
  '{} rows of {}': '{2} 的 {1} 行',
  '{} values of {}': '{2} 的 {1} 个值',
  'the next value': '下一个值',
  '{} take {} at the least, but {} are left: the file is cut off or damaged; copy it again':
    '{1}至少占 {2}，但只剩 {3}：文件被截断或已损坏；请重新复制',
  'a number is missing at the end; the file is cut off, copy it again': '末尾缺少一个数；文件被截断，请重新复制',
  'face {}': '面 {1}',
  'strip {}': '三角形带 {1}',
  'face {} has {} corners; at most {} are read': '面 {1} 有 {2} 个角；可读取的至多 {3} 个',
  'a list {} has the length {}': '有一个列表 {1} 的长度为 {2}',
  '{} names vertex {}; there are {}, counted from 0': '{1} 用到顶点 {2}；共有 {3} 个，从 0 数起',
  '{} of vertex {} is {}': '顶点 {2} 的 {1} 为 {3}',
  '{} of face {} is {}': '面 {2} 的 {1} 为 {3}',
  'no size': '没有尺寸',
  'the decoder gives no picture': '解码器没有给出图像',
  'WebGL2 is not available here': '此处没有 WebGL2',
  '{} × {} pixels are more than this device reads': '{1} × {2} 像素超出此设备所能读取',
  '{} things are elsewhere by less than a millimetre, at most {} mm; the first is {}: {}':
    '{1} 个物体的偏差不到一毫米，最多 {2} 毫米；第一个是 {3}：{4}',
  '{} and {} more: {}': '{1} 及另外 {2} 处：{3}',
  'info: {} more remarks of what is not drawn; slowlight inspect lists them':
    '提示：另有 {1} 条关于未绘制内容的说明；slowlight inspect 会全部列出',
  'its rows have {} values more than its header declares; they are left out':
    '其行中的数值比文件头声明的多 {1} 个；已略去',
  'its {} points are Gaussian splats, which are not shown; export it as a mesh':
    '它的 {1} 个点是高斯泼溅，不予显示；请导出为网格',
  'its {} points have no faces; points are not shown': '它的 {1} 个点不构成面；不显示点',
  '{} faces have fewer than 3 corners; they are left out': '{1} 个面的角不足 3 个；已将其去掉',

  // STL
  'of {} bytes is neither text (it does not begin with solid) nor long enough for a binary STL; copy it again':
    '共 {1} 字节，既不是文本（不以 solid 开头），也不够二进制 STL 的长度；请重新复制',
  '{} facets take {}, but the file has {}: it is cut off, or no STL; copy it again':
    '{1} 个三角形占 {2}，但文件只有 {3}：它被截断，或不是 STL；请重新复制',
  '{} bytes follow the {} facets; they are left out': '{2} 个三角形之后还有 {1} 字节；已将其去掉',
  'its colours are left out': '已去掉其颜色',
  'facet {} of {} has a corner at {}; the file is damaged, export it again':
    '第 {1} 个三角形（共 {2} 个）有一个角位于 {3}；文件已损坏，请重新导出',
  'the normals of {} facets say the opposite of the order of their corners, which is what is taken':
    '{1} 个三角形的法线与其角的顺序相反；以角的顺序为准',
  '{} should stand here, not {}; export it again': '此处应为 {1}，而不是 {2}；请重新导出',
  'the file ends inside a {}; it is cut off, copy it again': '文件在 {1} 之内结束；它被截断，请重新复制',
  'there are more than {} solids; join some': 'solid 超过 {1} 个；请合并一些',
  'a facet has 3 corners, this one more; export it again': '三角形有 3 个角，这一个更多；请重新导出',
  'a facet has 3 corners, this one {}; export it again': '三角形有 3 个角，这一个有 {1} 个；请重新导出',

  // Zip archives
  'the archive has no directory; it is cut off or no zip, copy it again':
    '压缩包没有目录；它被截断或不是 zip，请重新复制',
  'is a zip64 archive, which is not read; pack less than 4 GiB and 65 535 files, or open the folder itself':
    '是 zip64 压缩包，无法读取；请打包少于 4 GiB 和 65 535 个文件，或直接打开文件夹',
  'is one part of a split archive, which is not read; pack it as one file':
    '是分卷压缩包的一部分，无法读取；请打包成一个文件',
  'its directory ({} bytes at {}) goes beyond its end; it is cut off, copy it again':
    '其目录（位于 {2}，共 {1} 字节）超出了结尾；它被截断，请重新复制',
  'its directory is cut off; copy it again': '其目录被截断；请重新复制',
  'entry {} of its directory is damaged; copy it again': '其目录的第 {1} 项已损坏；请重新复制',
  'the name of a file at byte {} of its directory is no UTF-8; pack it again':
    '其目录中字节 {1} 处的文件名不是 UTF-8；请重新打包',
  "holds a file named '{}', which leads out of it; pack it again": '其中名为“{1}”的文件指向压缩包之外；请重新打包',
  'holds two files named {}; pack it again': '其中有两个名为 {1} 的文件；请重新打包',
  '{} in it is not where the directory says (byte {}); copy or pack it again':
    '其中的 {1} 不在目录所说的位置（字节 {2}）；请重新复制或打包',
  '{} in it is encrypted; pack it without a password': '其中的 {1} 已加密；请不用密码打包',
  '{} in it shares its bytes with another file; pack it again': '其中的 {1} 与另一个文件共用字节；请重新打包',
  '{} in it ends at byte {} of {}; it is cut off, copy it again':
    '其中的 {1} 结束于字节 {2}，而压缩包共 {3} 字节；它被截断，请重新复制',
  '{} in it claims {} of {} bytes, which cannot be; pack it again':
    '其中的 {1} 声称由 {3} 字节解压成 {2}，这不可能；请重新打包',
  '{} in it is packed by method {}, which is not read; pack it as a plain zip (deflate)':
    '其中的 {1} 以方法 {2} 压缩，无法读取；请打包成普通的 zip（deflate）',
  'unpacked it takes {}, more than the {} that are read; leave out what the scene does not use':
    '解压后占 {1}，超过可读取的 {2}；请去掉场景用不到的内容',
  'its {} unpack to {}; that is no scene': '它的 {1} 解压成 {2}；这不是场景',
  '{} in it {}; copy or pack it again': '其中的 {1} {2}；请重新复制或打包',
  'is cut off': '被截断',
  'is damaged: its check sum is another': '已损坏：校验和不符',
  'has {} bytes, not the {} that the directory says': '有 {1} 字节，而不是目录所说的 {2} 字节',
  'holds more than the {} bytes that the directory says': '超过目录所说的 {1} 字节',
  'cannot be unpacked ({})': '无法解压（{1}）',

  // What files of several kinds expect
  'a number': '数',
  'a name': '名称',
  'a type': '类型',
  // ———— Graph, nodes, dynamics, scenes, the page ————
  'Reads a scene file: {}.': '读取场景文件：{1}。',
  'None of these files is a scene. Drop a {} file, a panorama, or a folder or zip that contains one.':
    '这些文件中没有场景。请拖入 {1} 文件、全景图，或含有它们的文件夹或 zip。',
  'Projects; {}; panoramas; a folder or a zip where it has textures': '项目；{1}；全景图；带贴图时请选文件夹或 zip',
  'The lower it is, the stronger relativistic effects are. In nature: {} m/s.':
    '越低，相对论效应越明显。真实光速：{1} m/s。',
  circle: '圆周',
  spin: '自转',
  path: '路径',
  keys: '关键帧',
  'Saved {}, which cannot represent everything: {}{}': '已保存 {1}，但有内容无法保存：{2}{3}',
  '{} Or save the project and run it where a larger device is available: {}': '{1}或保存项目后在更强的设备上运行：{2}',
  '{} could not be loaded. Is the server still running?': '无法加载{1}。服务器还在运行吗？',
  Language: '语言',
  '{} opened': '已打开{1}',
  '{} closed': '已关闭{1}',
  '{} maximized': '已最大化{1}',
  '{} restored': '已还原{1}',
  'Arrow keys move the node, Enter opens the inspector, Delete removes it.':
    '方向键移动节点，Enter 打开检查器，Delete 删除节点。',
  'A connection of two nodes.': '两个节点之间的连接。',
  'Connection from {} to {}': '从 {1} 到 {2} 的连接',
  'expected {}, received {}': '应为{1}，而不是{2}',
  'expected {}': '应为{1}',
  'unknown: {}; leave it out': '没有这一项：{1}；请去掉',
  'more than {}': '大于 {1}',
  'more than {} entries': '多于 {1} 项',
  'an empty text': '空的文本',
  'less than {}': '小于 {1}',
  'fewer than {} entries': '少于 {1} 项',
  'a value is a number, true or false, a text, or a list of numbers or of texts':
    '值是数、true 或 false、文本，或者由数或文本组成的列表',
  'text in another form than expected': '文本的格式不符',
  'a name that is not allowed: {}': '不允许的名称：{1}',
  'none of the expected values': '不是允许的值',
  'true or false': 'true 或 false',
  nothing: '空',
  null: 'null',
  '{} is neither true nor false': '{1} 既不是 true 也不是 false',
  '{} is not a text': '{1} 不是文本',
  'the grid is drawn by the rasterizer only, where a project puts its picture together: switch it off':
    '项目自行组成画面时，网格只能由光栅化器绘制：请将其关闭',
  '{} views are more than the {} draws into one picture: up to {}':
    '{1} 个视图超过了{2}在一幅画面中可绘制的数目：至多 {3} 个',
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
  frame: '分组框',
  edge: '连线',
  '"{}" cannot be a node\'s name: letters, digits, - and _': '“{1}”不能作为节点的名称：只能用字母、数字、- 和 _',
  'a name is a letter and at most 63 more letters, digits, - or _': '名称以字母开头，其后至多 63 个字母、数字、- 或 _',
  '{}, here with a number after a dot where it takes many': '{1}；可接多条连线时在点后加编号',
  'a colour is # and six digits of 0…9, a…f': '颜色写作 # 加六位 0…9、a…f',
  'a hash is 64 digits of 0…9, a…f': '散列值是 64 位 0…9、a…f',
  'format: these are no nodes of Slowlight': 'format：这些不是 Slowlight 的节点',
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
  'Simulations that ended early, or whose energy went wrong: {} of {}. The Energy panel says of each what and why.':
    '{2} 个模拟中有 {1} 个提前结束或能量出错。“能量”面板说明每个的情形与原因。',
  '{}, c = {} m/s': '{1}，c = {2} m/s',
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
  'the energy has grown by {} J: steps of {} s are longer than the method can take here, {} s; take shorter ones':
    '能量增加了 {1} J：步长 {2} s 超过了该方法在此可用的 {3} s；请减小步长',
  'the GPU was lost ({}); go on, or compute it on the processor': 'GPU 已丢失（{1}）；请继续，或在处理器上计算',
  'steps of {} s are too long for the method: perturbations may grow; set a shorter step, or 0':
    '步长 {1} s 对该方法来说太长：微小的量可能每步增大；请设更短的步长，或设为 0',
  'from t = {} s on there is energy without a source, up to {} % of the largest kinetic energy: an error of the method; set a shorter step, or another method':
    '自 t = {1} s 起有能量凭空出现，最多为最大动能的 {2}%：是该方法的误差；请缩短步长，或换一种方法',
  'from t = {} s on energy is missing that nothing took, up to {} % of the largest kinetic energy: an error of the method; set a shorter step, or another method':
    '自 t = {1} s 起有能量无故消失，最多为最大动能的 {2}%：是该方法的误差；请缩短步长，或换一种方法',
  'the correction changed no step: it only holds back steps that gain energy; the correction by the root conserves it':
    '修正没有改变任何一步：它只抑制使能量增加的步；求根修正可使能量守恒',
  'after the step no velocities conserve the energy: {}; take a smaller step':
    '这一步之后，任何速度都不能使能量守恒：{1}；请缩短步长',
  'the potential energy alone is {} J above the total': '仅势能就比总能量高出 {1} J',
  'nothing moves that could have {} J': '没有运动的物体可以具有这 {1} J',
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
  scenes: '场景',
  'G-buffers': 'G 缓冲',
  steps: '步骤',
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
  'its stretch is {}; give it finite numbers and a positive determinant, or apply it to the mesh':
    '其伸缩矩阵为 {1}；请给出有限的数和正的行列式，或将其应用于网格',
  'it deforms, or is a round solid, and has a stretch; apply it to the mesh':
    '它会变形或是圆体，却带有伸缩矩阵；请将其应用于网格',
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
  '{}: nothing answers at its address. Check the network, then open it again':
    '{1}：其地址没有应答。请检查网络，然后重新打开',
  'Install as a program…': '安装为程序…',
  '{}: the server answers {} {}': '{1}：服务器回答 {2} {3}',
  'the server answers {}; check the address': '服务器回答 {1}；请检查地址',
  'it holds no .slowlight.json; save the project with its files again':
    '其中没有 .slowlight.json；请重新连同文件保存项目',
  '{} bytes are more than a project has; it holds words, not data':
    '{1} 字节超过了项目应有的大小；项目只含文字，不含数据',
  'the node asks for no file': '该节点不需要文件',
  'the browser made no PNG': '浏览器没有生成 PNG',
  'a worker could not be started': '无法启动工作线程',
  'it has no output node, so that it makes no picture; undo, or add one':
    '项目没有输出节点，因此没有图像；请撤销，或添加一个',
  'it waits for what is under way': '它在等待正在进行的工作',
  // ———— Effects in WGSL ————
  'line {}, column {}: {}': '第 {1} 行第 {2} 列：{3}',

  // The words of a text
  'the text has {} characters; more than {} are not taken: shorten it': '文本有 {1} 个字符，上限为 {2} 个：请缩短',
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
  'a part of a matrix cannot be assigned: build it anew': '不能给矩阵的一部分赋值：请重新构造矩阵',
  'WGSL assigns one component at a time: .x, .y, .z or .w': 'WGSL 一次只给一个分量赋值：.x、.y、.z 或 .w',
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
  '{} counts this loop, and may not be changed in it': '{1} 为此循环计数，不能在其中更改',
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

  // ———— Nodes and settings ————
  // Parameters
  View: '视图',
  'Light delay': '光的延迟',
  'Moving objects are seen where they were when the light left them.': '运动的物体显示在其发光时的位置。',
  Aberration: '光行差',
  'The directions of light depend on your velocity.': '光的方向随你的速度改变。',
  Colours: '颜色',
  'Doppler mix': '多普勒混合',
  'How strongly the Doppler shift affects colours.': '多普勒频移对颜色的影响程度。',
  Beaming: '聚束',
  'How strongly light is brighter ahead and darker behind.': '前方变亮、后方变暗的程度。',
  Shadows: '阴影',
  'Suns and lamps cast shadows, each from where the object was when the light passed it.':
    '太阳和灯投下阴影：每个物体的阴影取自光经过它时它所在的位置。',
  Exposure: '曝光',
  'Added to the metered exposure. Each stop doubles the brightness.': '在测光结果之上再加的曝光。每增加一档亮度加倍。',
  Metering: '测光',
  'Automatic follows the picture’s luminance, as an eye does. Resting eye uses the exposure of an observer at rest here, so that the headlight effect is visible. Manual is set by you alone.':
    '自动：像眼睛一样跟随画面亮度。静止之眼：按此处静止者的曝光，因而能看到聚束效应的真实强弱。手动：完全由你设定。',
  'Tone curve': '色调曲线',
  'Neutral keeps colours and compresses only very bright light; AgX compresses all light, as film does; Linear clips.':
    '中性：保持颜色，只压缩很亮的部分；AgX：像胶片一样整体柔化；线性：直接截断过亮的部分。',
  Solver: '求解器',
  'Exact: closed form or bisection. Newton: the iterative method, for comparison, in what is seen and in simultaneity.':
    '精确：二分加解析解。牛顿：迭代法，用于比较，适用于所见画面和同时性视图。',
  Iterations: '迭代次数',
  'More are more accurate, and slower.': '越多越精确，也越慢。',
  Damping: '阻尼',
  'Smaller steps diverge less easily.': '步长越小越不易发散。',
  Antialiasing: '抗锯齿',
  'Smooth edges, stable in motion; a still picture becomes finer over time. Off: every pixel shows what is at its centre.':
    '边缘平滑，运动时也稳定；静止画面会自动变得更精细。关：每个像素只显示其中心所见。',
  Ghost: '重影',
  'Contours of another view over the picture: where things are, over where they are seen, or the other way round.':
    '在画面上叠画另一视图的轮廓：在所见之处上显示物体实际所在，或反过来。',
  'Past and future': '过去与未来',
  'Draws apart what is in the world’s past and in its future, by its clocks, in slices of your own time and in their ghosts.':
    '在你自己时刻的同时面及其重影中，按世界的时钟区分属于世界过去与未来的部分。',
  'Ghost: {}': '重影：{1}',
  'Past, by the world’s clocks': '过去（按世界的时钟）',
  'Future, by the world’s clocks': '未来（按世界的时钟）',
  'Reference grid': '参考网格',
  'A grid on the ground that is not affected by relativity.': '不受相对论变形影响的地面网格。',
  'Animation speed': '动画速度',
  'Multiplies all speeds in the file. A constant acceleration is multiplied by the square and still stays below c.':
    '文件中的一切以此倍数加速。匀加速运动的加速度乘以其平方，且始终低于 c。',
  'Starts later by': '延后开始',
  'Delay of the animation relative to the file; negative values make it start earlier.':
    '动画比文件中晚这么久开始；负值表示提前。',
  'An object, or a group with its whole content.': '一个物体，或一个组及其全部内容。',
  Speed: '速度',
  'In units of the speed of light.': '以光速为单位。',
  Direction: '方向',
  'In the axes of the scene; its length does not matter.': '按场景坐标轴；长度无关紧要。',
  'Passes its position at': '经过原位的时刻',
  'World time at which it is where it would be without the flight.': '物体恰好位于不飞行时所在位置的世界时间。',
  'The file’s shape is that': '文件中的形状是',
  'At rest: the flight contracts it. In flight: it is already contracted. Deforming objects are always treated as in flight.':
    '静止时的形状：飞行会使其收缩。飞行时的形状：已是收缩后的长度。形变物体总按飞行时处理。',
  Samples: '采样',
  'n × n per pixel: four times as many samples halve the noise.': '每像素 n × n 个：采样数增至四倍，噪点减半。',
  Time: '时间',
  'World time of the observer’s event.': '观察者所在事件的世界时间。',
  'Noise threshold': '噪点阈值',
  'Adaptive sampling: pixels with little noise get fewer samples, and those that get all may have this standard error, relative to the light. 0: all get all.':
    '自适应采样：噪点少的像素采样较少；取满采样数的像素，其相对于光的标准误差可达此值。0：一律取满。',
  'Min samples': '最少采样',
  'With a noise threshold: n × n samples per pixel at least. More find what is small and bright.':
    '设有噪点阈值时：每像素至少 n × n 个采样。多取些，才不会漏掉又小又亮之物。',
  Denoise: '降噪',
  'Removes what is left of the noise by Open Image Denoise’s network. Few samples are enough; fine detail of shadows and reflections may be lost.':
    '用 Open Image Denoise 的网络去除余下的噪点。少量采样即可；阴影和反射的细节可能丢失。',
  Bounces: '散射次数',
  'How often light of the sky and of emissive surfaces is scattered on its way. 0: only suns and lamps; 1: also the sky and emissive surfaces; 2: also surfaces lit by these.':
    '天空与发光体的光在途中散射的次数。0：只有太阳和灯；1：加上天空和发光体；2：再加上被它们照亮的表面。',
  Mirrors: '镜面反射',
  'Smooth surfaces reflect each other; otherwise only the sky and emissive surfaces.':
    '光滑表面相互映照；否则只映照天空和发光体。',
  Glass: '玻璃',
  'Closed transparent objects refract light; otherwise they are blended with what is behind them.':
    '封闭的透明体折射光线；否则与其背后的景物混合。',
  Seed: '随机种子',
  'Seed of the random numbers: another seed gives other noise.': '随机数的种子：换一个，噪点随之不同。',
  'Ambient occlusion': '环境光遮蔽',
  'Dims the light of the sky where it is occluded, in corners and under objects.':
    '遮住天空之物使该处变暗，例如角落和物体下方。',
  'Radius (0: automatic)': '作用距离（0：按场景）',
  'Objects farther away than this do not occlude.': '比此更远的物体不遮挡该处的天空。',
  Effect: '效果',
  'Each effect has its own arguments, arg1 to arg4; values outside their ranges are clamped.':
    '每种效果有各自的数值 arg1 至 arg4；超出范围的按最近的端点计。',
  'Number 1 (arg1)': '数值 1（arg1）',
  'Number 2 (arg2)': '数值 2（arg2）',
  'Number 3 (arg3)': '数值 3（arg3）',
  'Number 4 (arg4)': '数值 4（arg4）',
  'Shader text': '着色器文本',
  'Spectral: light has spectra, and Doppler shift acts on wavelengths. The others are for comparison: a simple tint, and the methods of two earlier programs.':
    '光谱：光具有光谱，多普勒频移作用于波长。其余供比较：简单的染色，以及两个早期程序的方法。',
  'how Doppler shifts change colours: by spectra, or for comparison by a simple tint or the methods of two earlier programs':
    '多普勒频移如何改变颜色：按光谱；或供比较，用简单的染色或两个早期程序的方法',
  'Two wavelengths (historical)': '两个波长（历史方法）',
  'Image-based: drawn once for all velocities': '基于图像：一次绘制，用于所有速度',
  'draw once for all velocities': '一次绘制，用于所有速度',
  'draw at each velocity': '按每个速度绘制',
  'Test grid': '测试网格',
  'Lines of equal height and bearing through whatever lens the picture has, those of the horizon and of the direction ahead twice as thick, and the border of the part that is safe to use. For dome masters the zenith is in the middle. Place it after Tone Map.':
    '透过图像所用的任何镜头画出等高度和等方位的线，地平线和前方方向的线加倍粗，以及可安全使用部分的边框。对穹顶母版，天顶在中间。放在“色调映射”之后。',
  'Lines every': '线间隔',
  'Safe part (0: no border)': '安全部分（0：无边框）',
  'Width of the lines': '线宽',
  'Linear spectrum (historical)': '线性光谱（历史方法）',
  'this would overwrite {}, the stage that the geometry goes into; choose another file name':
    '这会覆盖 {1}，即要写入的场景文件；请选择其他文件名',
  'Prim path': '基元路径',
  'Only this prim and what is below it, such as /World/Car, where it is in the stage and with the materials that it inherits; empty: everything.':
    '只读取此基元及其下的一切，例如 /World/Car，保持其在场景中的位置和继承的材质；空：全部。',
  'Everything is written below this prim, such as /geom/geometry; empty: where it is.':
    '一切都写在此基元之下，例如 /geom/geometry；空：保持原位。',
  'Into the stage': '写入场景文件',
  'A USD file of the project. A new stage is written that has it and the geometry; the file itself is not changed. Keep them in one folder.':
    '项目中的一个 USD 文件。写出一个包含它和几何体的新场景文件；该文件本身不变。请放在同一文件夹中。',
  As: '方式',
  'Sublayer: a layer below those of the stage. Payload: of a new prim, which programs can leave unloaded.':
    '子层：位于场景各层之下的一层。载荷：属于一个新基元，程序可以不加载它。',
  Sublayer: '子层',
  Payload: '载荷',
  '"{}" is no path of a prim; write one like {}': '“{1}”不是基元路径；请写成 {2} 这样',
  'the name {} has characters that USD takes for the end of it; rename the file':
    '名称 {1} 含有 USD 会当作结尾的字符；请重命名该文件',
  'in {} {} is up, in the geometry {}; make the geometry in the axes of the stage':
    '在 {1} 中 {2} 轴朝上，几何体中是 {3} 轴；请按场景文件的坐标轴制作几何体',
  'there is a prim {} already, and nothing is overwritten; choose another path':
    '已有基元 {1}，不会覆盖任何内容；请选择其他路径',
  'there is nothing at {}; there is {}': '{1} 处没有任何内容；有 {2}',
  'there is nothing to be seen at {}, and no light and no camera; choose another path':
    '{1} 处没有可见的内容，也没有灯光和相机；请选择其他路径',
  'there is no prim {}; below {} there is {}': '没有基元 {1}；{2} 之下有 {3}',
  'there is no prim {}; {} has nothing below it': '没有基元 {1}；{2} 之下没有任何内容',
  'The background of the scene: a uniform sky, a gradient from the horizon to the zenith and to the ground, or the stars. Post process with Sky background lets distant things fade into it.':
    '场景的背景：均匀的天空、从地平线到天顶和地面的渐变，或星空。用“后期处理”的“天空背景”可让远处的物体淡入其中。',
  Zenith: '天顶',
  Horizon: '地平线',
  Ground: '地面',
  'A checkerboard or a picture on surfaces, in place of their colour. The rest of their material stays: put it after Material.':
    '表面上的棋盘格或图片，取代其颜色。材质的其余部分不变：请放在“材质”之后。',
  Checkerboard: '棋盘格',
  'A PNG or JPEG.': 'PNG 或 JPEG。',
  'First colour': '第一种颜色',
  'Second colour': '第二种颜色',
  Tint: '染色',
  Texture: '纹理',
  Filter: '过滤',
  'Nearest: texels have sharp edges. Linear: they blend.': '最邻近：纹素边缘锐利。线性：相互融合。',
  Nearest: '最邻近',
  Mapping: '映射',
  'By the surface’s own texture coordinates, or projected along the axes.': '按表面自己的纹理坐标，或沿坐标轴投影。',
  'Its own': '自己的',
  Projected: '投影',
  'Cells or pictures along u': '沿 u 的格数或图片数',
  'Cells or pictures along v': '沿 v 的格数或图片数',
  'Size of a cell or picture': '一格或一张图片的大小',
  '{} deforms, so that a projected texture would slide over it; use its own coordinates':
    '{1} 会变形，投影的纹理会在其上滑动；请用它自己的坐标',
  '{} has no texture coordinates; project the texture instead': '{1} 没有纹理坐标；请改用投影',
  'no image is named; name a PNG or JPEG': '没有指定图像；请指定 PNG 或 JPEG',
  'Load text…': '载入文本…',
  'Choose a file…': '选择文件…',
  'Save text': '保存文本',
  'Shader file': '着色器文件',
  'A file with the text, in WGSL or GLSL, such as blur.fs; it comes before the text above.':
    '含有文本的文件，用 WGSL 或 GLSL 写成，例如 blur.fs；它优先于上面的文本。',
  'the text reads a second image, and none is connected: connect one to “Second image”':
    '文本读取第二幅图像，但没有连接：请将一幅图像连到“第二幅图像”',
  'Second image': '第二幅图像',
  '{} has {} bytes; a shader text has {} characters at most': '{1} 有 {2} 字节；着色器文本最多 {3} 个字符',
  'Blends two images. Split shows them side by side, wipe moves the border between them, inset shows the upper one small in a corner, and a custom mode is what you write.':
    '将两幅图像合为一幅。分屏左右并列显示，擦除以移动的边界切换，小窗把上层图像缩小后放在角上，自定义模式由你编写。',
  'WGSL: fn effect(p: Pixel) -> vec4f returns the colour of a pixel, from image(offset), which is below, image2(offset), which is above, and arg1, which is alpha. Or GLSL with a void main().':
    'WGSL：fn effect(p: Pixel) -> vec4f 返回像素的颜色，可用下层 image(offset)、上层 image2(offset) 和 arg1（即 alpha）。也可用带 void main() 的 GLSL。',
  'An effect over an image: a built-in one or your own. It can read a second image and the visible surfaces; a mask limits it to where the mask is bright.':
    '对图像施加效果：内置的或自己编写的。它可以读取第二幅图像和可见的表面；遮罩将其限制在遮罩明亮之处。',
  'WGSL: fn effect(p: Pixel) -> vec4f returns the colour of a pixel, from image(offset), image2(offset), depth(offset), normal(offset), albedo(offset) …, p.uv, arg1 … arg4 and time. Or GLSL with a void main().':
    'WGSL：fn effect(p: Pixel) -> vec4f 返回像素的颜色，可用 image(offset)、image2(offset)、depth(offset)、normal(offset)、albedo(offset)……、p.uv、arg1 … arg4 和 time。也可用带 void main() 的 GLSL。',
  'Hue shift': '色调偏移',
  'Turns the hues, and strengthens or weakens them; the luminance stays. It has nothing to do with the Doppler effect.':
    '旋转色调，并可增强或减弱；亮度不变。与多普勒效应无关。',
  Angle: '角度',
  Saturation: '饱和度',
  '{} is not declared here: declare it before, or is it spelt otherwise?': '{1} 在这里没有声明：请先声明，或检查拼写',
  'a Pixel has no {}: it has position, uv, size, direction, view, projection and color':
    'Pixel 没有 {1}：它有 position、uv、size、direction、view、projection 和 color',
  'a matrix is not made of a vector': '矩阵不能由一个向量构造',
  'write a `for` whose count is known: {}': '请写次数已知的 `for`：{1}',
  'return the value': '请返回该值',
  'use int': '请用 int',
  'use float': '请用 float',
  'compare components one by one': '请逐个比较分量',
  'use a square matrix': '请用方阵',
  'pixels are read by samplers declared outside of functions: `uniform sampler2D`':
    '像素由函数之外声明的采样器读取：`uniform sampler2D`',
  'there is no function main: write `void main() { … }`': '没有函数 main：请写 `void main() { … }`',
  'arrays are not taken: pass and return numbers, vectors and matrices': '不支持数组：请传递和返回数、向量和矩阵',
  'use sampler2D': '请用 sampler2D',
  'nothing is known by the name of the sampler {}: there are {}': '没有名为 {1} 的采样器：可用的有 {2}',
  'nothing is known by the name of `{}`: there are {}': '没有 `{1}`：可用的有 {2}',
  '{} is of type {}': '{1} 的类型是 {2}',
  'there is a second output: a pixel has one colour': '有第二个输出：一个像素只有一种颜色',
  'the type {} is not known: there are {}': '类型 {1} 未知：有 {2}',
  'variables outside of functions are not taken: declare them inside, or with `const`':
    '不支持函数之外的变量：请在函数内声明，或用 `const`',
  '{} returns nothing: let it return a value': '{1} 不返回任何值：请让它返回一个值',
  'main has no parameters': 'main 没有参数',
  'the loop counts more than one variable: declare the others before it': '循环计数多个变量：请在循环之前声明其余变量',
  'a sampler is no value: read it by `texture({}, uv)`': '采样器不是值：请用 `texture({1}, uv)` 读取',
  'a sampler': '采样器',
  '{} is no sampler: `uniform sampler2D {};` before it': '{1} 不是采样器：请先写 `uniform sampler2D {2};`',
  '{} takes {} values, and has {}': '{1} 需要 {2} 个值，却有 {3} 个',
  'its macros make the text longer than {} words: shorten it': '宏使文本超过 {1} 个词：请缩短',
  '`#{}` is not taken: there are `#version`, `#define` and `#undef`':
    '不支持 `#{1}`：有 `#version`、`#define` 和 `#undef`',
  'expected a name for the macro here': '此处应为宏的名称',
  'the macro {} has arguments, which are not taken: write a function': '宏 {1} 带有参数，不支持：请写函数',
  'the macro {} is longer than {} words: write a function': '宏 {1} 超过 {2} 个词：请写函数',
  'the character {} has no meaning in {}': '字符 {1} 在 {2} 中没有意义',
  '{} is no variable here: declare it before': '{1} 在这里不是变量：请先声明',
  '{} cannot be changed: copy it into a variable': '{1} 不能更改：请复制到变量中',
  'this assigns one component twice': '这里给同一分量赋值两次',
  'the loop declares no counter of its own: write {}': '循环没有声明自己的计数变量：请写 {1}',
  '{} counts, and should be {}': '{1} 用于计数，应为 {2}',
  Mode: '模式',
  'Blends linear light: values brighter than white are kept.': '对光进行混合：比白更亮的保持其亮度。',
  Alpha: '不透明度',
  'Opacity of the upper image; for split and wipe, position of the border; for inset, its share of the picture’s width.':
    '上层图像在结果中的比例；分屏与擦除时为边界的位置；小窗时为它占画面宽度的比例。',
  'Without folders. .png is as displayed; .exr is radiance before exposure and tone curve.':
    '不含文件夹。.png 如屏幕所示，.exr 为曝光与色调曲线之前的光。',
  'Without folders. .mp4 and .gif are films; .png and .exr are frames, whose numbers replace ####: film.####.png. A .gif repeats for ever, has 256 colours, and frames of whole hundredths of a second, right on average.':
    '不含文件夹。.mp4 和 .gif 为影片；.png 和 .exr 为逐帧文件，编号代替 ####：film.####.png。.gif 无限循环，有 256 种颜色，每帧时长为百分之一秒的整数倍，平均而言准确。',
  'a .gif has between one frame in 655 s and {} a second, not {}; choose another rate, or write an .mp4':
    '.gif 的帧率在每 655 s 一帧到每秒 {1} 帧之间，不能是 {2}；请另选帧率，或写出 .mp4',
  'a .gif of {} × {} pixels is too large; write at most {} along a side, or an .mp4':
    '{1} × {2} 像素的 .gif 太大；每边至多 {3} 像素，或写出 .mp4',
  'World time of the observer’s event; default: the time at which the scene opens.':
    '观察者事件的世界时间；未设置时为场景打开的时刻。',
  'Frames per second': '每秒帧数',
  'Observer stays in place': '观察者停在原处',
  'On: the picture has the observer’s velocity, from a fixed position. Off: the observer coasts.':
    '开：以观察者的速度、从同一位置所见。关：观察者惯性前行。',
  'Along each side of a pixel: 4 means 16 per pixel. If the rasterizer’s antialiasing is off, a pixel shows what is at its centre.':
    '像素每边的采样数：4 表示每像素 16 个。光栅化关闭抗锯齿时，只取像素中心。',
  Operation: '运算',
  Relation: '关系',
  Tolerance: '容差',
  Second: '第二个',
  'Off: passes A. On: passes B.': '关：输出 A；开：输出 B。',
  Factor: '系数',
  'Speed of light': '光速',
  'Maximum speed': '最大速度',
  'Your maximum speed while Shift is held. Without Shift: half of it, or 8 m/s if that is less.':
    '按住 Shift 时的最高速度；不按时取其一半与 8 m/s 中较小者。',
  'Shows a quantity as colours: the Doppler factor D; the emission time; the luminance before exposure; the visible part of the emitted spectrum.':
    '用颜色表示数值：多普勒因子 D；所见事件的发生时间；曝光前的亮度；看到的是发射光谱的哪一部分。',
  'Follow the scene’s animated camera with its velocity. Any movement key detaches you.':
    '跟随场景自带的动画相机及其速度；按任意移动键即可接管。',
  "--aperture is the angle across a fisheye's circle: add --lens fisheye or dome, or leave it out":
    '--aperture 是鱼眼画面圆的张角：请加上 --lens fisheye 或 dome，或者去掉它',
  '--dome-tilt is for domes: add --lens dome, or leave it out': '--dome-tilt 用于球幕：请加上 --lens dome，或者去掉它',
  '--fov is of a perspective lens; --lens {} sees {}: leave it out':
    '--fov 属于透视镜头；--lens {1} 看到的是{2}：请去掉它',
  'its --aperture': '它的 --aperture 范围',
  'all around': '四周全景',
  'degrees above 0 and at most 360': '大于 0、不超过 360 的度数',
  'degrees from -90 to 90': '−90 到 90 的度数',
  'how directions are shown: perspective; equirectangular, 360° around; fisheye, ahead in the middle; dome, a dome master: the zenith in the middle, ahead at the bottom; cube, 3 × 2 faces; cube-strip, six in a row; stereo, 360° for two eyes, the left one’s picture above (default: perspective)':
    '方向如何显示：perspective 透视；equirectangular 等距柱状，360° 全景；fisheye 鱼眼，前方在中央；dome 球幕母版，天顶在中央，前方在下方；cube 立方体，3 × 2 个面；cube-strip 六个面排成一行；stereo 供双眼观看的 360° 全景，左眼画面在上（默认：perspective）',
  "of stereo: the distance of the eyes, in the observer's frame [m] (default: {})":
    '用于 stereo：两眼的距离，在观察者的参考系中 [m]（默认：{1}）',
  '--eye-separation is for two eyes: add --lens stereo, or leave it out':
    '--eye-separation 用于双眼：请加上 --lens stereo，或去掉它',
  'a stereo picture has one eye’s picture, twice as wide as high, above the other’s, and is as wide as high; {} × {} is not, or not even: take {} × {}':
    '立体画面由上下两幅单眼画面组成，每幅宽是高的两倍，整幅宽高相等；{1} × {2} 不符合，或不是偶数：请用 {3} × {4}',
  'of fisheye and dome: the angle across the circle (default: {})': '用于 fisheye 和 dome：画面圆的张角（默认：{1}）',
  'of dome: by how much the dome is tilted towards the front (default: {})':
    '用于 dome：球幕向前倾斜的角度（默认：{1}）',
  'picture size in pixels; of --lens equirectangular by default 2048x1024, of fisheye and dome 1024x1024, of cube 1536x1024, of cube-strip 3072x512, of stereo 2048x2048':
    '画面的像素尺寸；--lens equirectangular 默认 2048x1024，fisheye 和 dome 默认 1024x1024，cube 默认 1536x1024，cube-strip 默认 3072x512，stereo 默认 2048x2048',
  Lens: '镜头',
  'How directions are shown. Equirectangular, cube and stereo pictures show all around; a dome master has the zenith in the middle and what is ahead at the bottom.':
    '方向如何显示。等距柱状、立方体和立体画面显示四周全景；球幕母版的中央是天顶，下方是前方。',
  'Angle of view': '视角',
  'The angle across the circle.': '画面圆的张角。',
  'Dome tilt': '球幕倾角',
  'By how much the dome is tilted towards the front.': '球幕向前倾斜的角度。',
  'Stereo, 360°': '立体 360°',
  'As the file says': '按文件说明',
  'Of the picture. As the file says, or by its shape: latitude and longitude, or faces of a cube. A fisheye and a dome master are circles in the middle of a picture.':
    '画面所用的镜头。按文件说明，或按其形状：经纬画面，或立方体的各面。鱼眼和球幕母版是画面中央的一个圆。',
  'Distance of the eyes': '两眼距离',
  'In your rest frame. Far-off things look deep with eyes that are farther apart, as if the world were smaller.':
    '在您的静止系中。两眼离得越远，远处的物体看起来越有立体感，仿佛世界变小了。',
  '{} is of a perspective lens; leave it out, or choose that lens': '“{1}”只适用于透视镜头；请去掉它，或改用透视镜头',
  Perspective: '透视',
  'Equirectangular, 360°': '等距柱状，360°',
  Fisheye: '鱼眼',
  Dome: '球幕',
  'Cube, 3 × 2 faces': '立方体，3 × 2 个面',
  'Cube, faces in a row': '立方体，六面一行',
  'an equirectangular picture is twice as wide as high, and {} × {} is not; take {} × {}':
    '等距柱状画面的宽是高的两倍，而 {1} × {2} 不是；请用 {3} × {4}',
  'the faces of a cube are square, {} of them, and those of {} × {} are not; take {} × {}':
    '立方体的 {1} 个面是正方形，而 {2} × {3} 的面不是；请用 {4} × {5}',
  'Field of view': '视场角',
  'Vertical, in your rest frame.': '竖直方向，在你自己的参考系中。',
  Name: '名称',
  'Name in the scene: letters, digits and _.': '在场景中的名称：字母、数字和 _。',
  'Applies to': '对象',
  'Path of an object, with everything below it, such as /Car; empty for everything.':
    '物体的路径（含其下属），如 /Car；留空表示全部。',
  Axis: '轴',
  'Width (x)': '宽（x）',
  'Height (y)': '高（y）',
  'Depth (z)': '深（z）',
  Width: '宽度',
  Length: '长度',
  Height: '高度',
  Columns: '列数',
  Rows: '行数',
  Radius: '半径',
  Segments: '分段数',
  Rings: '环数',
  Cone: '尖顶',
  'A cone instead of a cylinder.': '圆锥而不是圆柱。',
  'Ring radius': '环半径',
  'Tube radius': '管半径',
  'Tube segments': '管分段数',
  'File name': '文件名',
  'Without folders. `.usda` is text, `.usdz` a package with textures, `.usdc` binary and smaller.':
    '不含文件夹。`.usda` 为文本，`.usdz` 为连同贴图的包，`.usdc` 为更小的二进制。',
  'Sampled motions can be read by every program; the time range is that of the input, else of the geometry. Exact motions and rest shapes are read by Slowlight only.':
    '采样可被所有程序读取，时间范围取自输入，否则取几何体自身的。精确运动与静止形状只有 Slowlight 能读。',
  'Moving rest shapes are contracted by it; it is written to the file as the suggested speed of light.':
    '静止形状在运动中据此收缩；并写入文件，作为观看时的光速。',
  'Cap height': '大写字母高度',
  Alignment: '对齐',
  'Letter spacing': '字距',
  'Additional space, in cap heights.': '附加间距，以大写字母高度为单位。',
  'Line height': '行距',
  'In cap heights.': '以大写字母高度为单位。',
  'Curve tolerance': '曲线偏差',
  'Maximum deviation of line segments from the curve, in cap heights: smaller is rounder, with more triangles.':
    '直线段偏离曲线的最大距离，以大写字母高度为单位：越小越圆滑，三角形越多。',
  'Cells in x': 'x 方向格数',
  'Cells in y': 'y 方向格数',
  'Cells in z': 'z 方向格数',
  Cell: '格边长',
  Thickness: '杆粗',
  Position: '位置',
  Rotation: '旋转',
  Scale: '缩放',
  'Scales sizes, and with them the distances and speeds of motions.':
    '整体放大的倍数；运动物体在同样时间内走过的路程也按此倍数增大。',
  Arrangement: '排列',
  'Count in x': 'x 方向个数',
  'Count in y': 'y 方向个数',
  'Count in z': 'z 方向个数',
  Count: '个数',
  Spacing: '间距',
  Surface: '表面',
  'A surface modelled on measurements, including ultraviolet and infrared, or a custom one.':
    '近似实测的表面（含紫外与红外），或自定义。',
  Roughness: '粗糙度',
  Metallic: '金属度',
  Opacity: '不透明度',
  Emission: '发光',
  'Emitted light; 1 is as bright as a white surface in full daylight.': '自身发光的亮度；1 相当于日光下的白色表面。',
  Temperature: '温度',
  'Temperature of the blackbody emission.': '发光所对应的黑体温度。',
  Levels: '级数',
  'The same shape with smaller triangles, or a smooth surface (Loop subdivision).':
    '形状不变、三角形更小，或生成光滑曲面（Loop 细分）。',
  'Begins at': '开始于',
  'Ends at': '结束于',
  Velocity: '速度',
  'Proper acceleration': '固有加速度',
  'At rest at': '静止时刻',
  Centre: '中心',
  'Along the circle; negative values reverse the direction.': '沿圆周的速率；负值表示反方向。',
  'Face along motion': '朝向前进方向',
  'Turns with the direction of motion; otherwise it keeps its pose.': '随运动转向；否则保持姿态。',
  From: '开始',
  To: '结束',
  Rate: '角速度',
  Waypoints: '途经点',
  'One point per line: x y z in metres.': '每行一个点：x y z（米）。',
  'One key per line: t x y z, with rotation also rx ry rz; seconds, metres, degrees.':
    '每行一帧：t x y z，需要转动时加 rx ry rz；单位为秒、米、度。',
  'Shines towards': '照射方向',
  'Full daylight is about 3.': '以日光约为 3 的单位。',
  Irradiance: '辐照度',
  Reflectance: '反射率',
  'A CSV table: each line has a wavelength in nm and the reflected fraction, 0 to 1. The colour is then that of the table.':
    'CSV 表格：每行一个波长（nm）和反射比例（0 到 1）。设置后颜色取自该表格。',
  'The spectrum of the light at rest, which determines the colours after a Doppler shift. Daylight whose colour is that of a blackbody is treated as one.':
    '静止时光的成分：决定多普勒频移后呈现的颜色。选“日光”的太阳和灯若颜色接近炽热物体，则按该色温计算。',
  Shape: '形状',
  Size: '尺寸',
  'Width; a point has none.': '宽度；点光源没有尺寸。',
  Brightness: '亮度',
  Kind: '种类',
  'Looks at': '注视点',
  'Opens at': '打开时刻',
  Mass: '质量',
  'Mass of each object.': '每个物体的质量。',
  'Along edges': '沿边弹簧',
  'Stiffness of these springs; 0: none.': '弹簧的劲度；0 表示没有。',
  'Across faces': '跨面弹簧',
  'Along the diagonals of quads.': '沿四边形的对角线。',
  'Against bending': '抗弯弹簧',
  'From each point to its second neighbours.': '连到隔一个的点。',
  'To the centre': '填充弹簧',
  'From each point to the centre of its object: hollow objects keep their shape.':
    '各点连到物体中心：空心物体得以保持形状。',
  'Rest length': '自然长度',
  'As a fraction of the initial length of the springs: below 1 they are under tension.':
    '与起始长度之比：小于 1 时弹簧绷紧。',
  'Pinned points': '固定',
  'Points that stay in place or, if the object is animated, follow its animation.':
    '哪些点保持不动；若物体本身在运动，这些点随它运动。',
  Points: '点编号',
  'Vertex numbers starting at 0: 0, 9, 20-29.': '顶点编号，从 0 开始：0, 9, 20-29。',
  'Initial velocity': '初速度',
  'Initial spin': '初始自转',
  Charge: '电荷',
  'Charge of each object.': '每个物体的电荷。',
  'A plane is solid behind its front.': '平面正面之后为实体。',
  'Contact stiffness': '接触劲度',
  'Stiffness of the contact force; faster impacts penetrate deeper.': '推出侵入物的劲度；撞得越重陷得越深。',
  'Contact scale': '放大',
  'Size in contact relative to the displayed size.': '碰撞时比显示尺寸大的倍数。',
  Margin: '间隙',
  'Distance at which contact begins.': '与接触物之间保持的距离。',
  Free: '自由',
  'Moved by contact; otherwise it is fixed, or keeps its animation.': '受碰撞推动；否则固定不动，或照自身的运动而动。',
  'Held by rods': '杆连接',
  'Thin springs as stiff as rods: pendulums, or chains of the objects in order.':
    '如杆一般硬的细弹簧：单摆，或按次序连成的链。',
  Pivot: '悬点',
  'Position of the fixed end relative to the sphere’s centre.': '固定端相对球心的位置。',
  'Stiffness of rods': '杆的劲度',
  'Thickness of rods': '杆粗',
  '0: rods are not displayed.': '0 表示不显示。',
  Gravity: '重力',
  'Force per kilogram of rest mass, independent of speed.': '每千克静止质量所受的力，与速度无关。',
  'Air drag': '空气阻尼',
  'Fraction of the momentum that air removes per second.': '空气每秒带走的动量比例。',
  'Electric field': '电场',
  'Magnetic field': '磁场',
  'Charges act on each other': '电荷相互作用',
  'Instantaneous, without propagating fields.': '瞬时作用，没有传播的场。',
  'The file is used as it is, even if the input has changed since.': '按文件显示：不再查看输入，即使输入已经改变。',
  'The limiting speed; the scene then suggests it for viewing.': '不可达到的速度；场景随后建议以此光速观看。',
  Mechanics: '力学',
  'Newton’s mechanics is computed as if c were infinite, and may exceed the speed of light used for viewing.':
    '牛顿力学按 c 无穷大计算，可能快过观看所用的光。',
  Duration: '时长',
  'Number of recorded frames; steps are shorter.': '保留的帧数；步长更短。',
  Method: '方法',
  'The discrete gradient conserves energy; splitting methods are fast, and their energy oscillates without a trend; the last three are those of the source documents, for comparison.':
    '离散梯度保持能量；分裂法快，能量只摆动、无趋势；最后三种来自原始文献，用于比较。',
  Correction: '能量修正',
  'Correction of the energy after each step. Tangent and secant apply a fraction of the change of velocity: they hold back steps that gain energy, and the secant leaves those that lose it, as implicit steps do. The root multiplies all momenta by the factor that conserves the energy to rounding; where there is none, the run ends.':
    '每步之后对能量的修正。切线与割线只施加速度变化的一部分：它们抑制使能量增加的步；割线不改变使能量减少的步，隐式步即是如此。求根则把所有动量乘以同一因子，使能量守恒至舍入误差；若无此因子，模拟即告终止。',
  'On the GPU': '在 GPU 上',
  'Takes the steps on the graphics processor, in 32-bit floats: for cloths of many thousands of points. Their rounding error is about a millionth of the kinetic energy.':
    '由图形处理器以 32 位数计算各步：适合有成千上万个点的布料；舍入误差约为动能的百万分之一。',
  'Error per second': '每秒误差',
  'Steps adapt to keep the error of any position [m] and velocity [m/s] below this per second; 0: fixed steps.':
    '步长随误差调整：每秒内任一点的位置误差 [m] 与速度误差 [m/s] 不超过此值；0 表示步长固定。',
  Step: '步长',
  'Maximum step; 0: a tenth of the stability limit of an explicit method.':
    '最长步长；0 表示取显式方法可承受的十分之一。',
  'Contact distance': '接触距离',
  'Points of nets that come nearer repel each other: between objects, and within an object that folds if they are farther apart at rest. About the length of an edge; 0: no contact.':
    '弹簧网的点近于此距离时互相推开：不同物体之间如此，同一物体折叠时，静止时相距更远的点之间也如此。约取一条边的长度；0 表示互不作用。',
  'A number, or an expression with units: 0.9*c, 30deg, 5 km/h, sqrt(2)':
    '数值，或带单位的表达式：0.9*c、30deg、5 km/h、sqrt(2)',
  'from {}': '来自 {1}',
  'What flies': '飞行物体',
  'False colours': '伪彩色',
  'not physical': '非物理',
  'For teaching and comparison: in nature this is {}.': '用于教学与比较：自然界中此值为 {1}。',
  'Ride the camera': '跟随相机',

  // Views
  Seen: '所见',
  Simultaneity: '同时面',

  // Colours
  Spectral: '光谱',
  Approximate: '近似',

  // Metering
  Automatic: '自动',
  'Resting eye': '静止之眼',
  Manual: '手动',

  // Tone curves
  Neutral: '中性',
  AgX: 'AgX',
  Linear: '线性',

  // Solvers
  Exact: '精确',
  Newton: '牛顿',

  // Nodes: titles and help
  Read: '读取',
  File: '文件',
  Variants: '变体',
  'Between samples': '样本之间',
  'Interpolation between the time samples of a USD file: linear, as USD specifies, or cubic, so that velocities do not jump.':
    'USD 动画在样本之间的运动方式：直线（USD 的规定），或三次曲线，速度不会突变。',
  Animation: '动画',
  'When the file’s animation begins, and how fast it runs. Motion faster than light is refused.':
    '文件动画何时开始、以多快速度播放。超过光速的运动会被拒绝。',
  'Makes an object, with everything below it, fly along a straight line. Rigid objects keep their pose and lose their own motion; deforming objects keep deforming, and its velocity is added to theirs in the world frame.':
    '让物体及其下属部分沿直线飞行。刚体保持姿态、不再有原来的运动；形变物体继续形变，其速度在世界参考系中与飞行速度相加。',
  Scene: '场景',
  'Composes what is observed. A sky or panorama that is connected replaces those of files.':
    '组成被观察的场景。连接的天空或全景图会取代文件中的天空。',
  Panorama: '全景图',
  'A picture or a film of all directions as surroundings at infinity, which also shine on things: by latitude and longitude, or six faces of a cube. It replaces the sky of the files in Scene.':
    '以一张包含所有方向的图片或一部这样的影片作为无穷远处的环境，它也照亮物体：按经纬度展开，或立方体的六个面。在“场景”中它取代文件的天空。',
  'A picture twice as wide as high, or of six square faces: PNG, JPEG, WebP, AVIF, Radiance (.hdr) or OpenEXR, or such a film: MP4, QuickTime, WebM or Matroska. Of a scene its dome is taken.':
    '宽为高两倍的图片，或六个正方形面组成的图片：PNG、JPEG、WebP、AVIF、Radiance（.hdr）或 OpenEXR；或这样的影片：MP4、QuickTime、WebM 或 Matroska。若为场景文件，则取其天穹。',
  'Film starts at': '影片开始于',
  'World time at which the first picture of a film is in the origin.': '影片的第一幅画面到达原点的世界时间。',
  'Before and after it': '影片前后',
  'What is seen of a film before it starts and after it ends.': '影片开始之前和结束之后所见。',
  'Its first and last picture': '第一幅和最后一幅画面',
  'It repeats': '重复播放',
  'Turns the surroundings to the left, about the zenith.': '使环境绕天顶向左转动。',
  Tilt: '倾斜',
  'Raises what is in the middle of the picture, before it is turned.': '在转动之前，抬高图片中央的内容。',
  'The axis of the scene that points to the upper edge of the picture.': '场景中指向图片上边缘的轴。',
  'A factor of the picture’s light.': '图片光亮的倍数。',
  'Its colours are': '颜色解释为',
  'Spectra of the picture’s colours, which determine them after a Doppler shift. A sky: white, blue scattered and red transmitted daylight, and a filter for the rest. A filter: of a light of the spectrum below, or of a connected one.':
    '图片颜色所代表的光谱，它决定多普勒频移后的颜色。天空：白色日光、散射的蓝光、透射的红光，其余为滤光片。滤光片：置于下面所选光谱或所连接光谱的光之前。',
  'Those of a sky': '天空的光谱',
  'A filter before a light': '光源前的滤光片',
  'no picture is chosen; name one': '未选择图片；请指定一张',
  '{} has no surroundings; name a panorama': '{1} 没有环境；请指定一张全景图',
  'Relativity console': '相对论控制台',
  'How light travels, and the speed limits.': '光如何传播，以及你能多快。',
  Camera: '相机',
  'The camera from which the scene is observed.': '从何处观看场景。',
  'Relativity rasterize': '相对论光栅化',
  'Rasterizes what the observer sees into a G-buffer: per pixel the surface, its emission event, its velocity and its Doppler factor.':
    '将观察者所见绘制到 G 缓冲：每个像素对应的表面、事件、速度与多普勒因子。',
  Rasterize: '普通光栅化',
  'Rasterizes like a non-relativistic renderer: as if light were infinitely fast, without Doppler shift and beaming.':
    '普通渲染器所绘：光速视为无穷大，没有多普勒频移和聚束效应。',
  'Reference render': '参考渲染',
  'A still by the reference renderer: rays traced into the past in 64-bit arithmetic, including light that objects cast on each other. It uses the camera and the time set here, not the flying observer. It is centred in the picture at full height; what is wider is cropped. It takes a while, on all processors.':
    '由精确渲染器生成的静帧：以 64 位运算向过去追踪光线，包含物体之间相互照射的光。画面取自相机和此处设定的时间，而不是飞行中的观察者。它与画面同高、居中放置，超宽部分被裁去。需要一些时间，占用全部处理器。',
  'Deferred lighting': '延迟光照',
  'Shades a G-buffer, each surface in its own rest frame: the radiance that the observer receives.':
    '对 G 缓冲着色，每个表面在其静止参考系中计算：观察者接收到的光。',
  'The visible fraction of the sky at each point as a mask, which can be smoothed, viewed, or multiplied with an image.':
    '每处所见天空的比例，单独输出为遮罩：可平滑、查看或与图像相乘。',
  'Post process': '后期处理',
  'Mix colour': '混合颜色',
  'False colour': '伪彩色',
  'Shows a quantity as colours with a legend: Doppler factor, emission time, luminance, or the visible part of the emitted spectrum.':
    '以颜色表示画面中的数值并附图例：多普勒因子、发光时刻、亮度，或所见的光谱部分。',
  'Tone map': '色调映射',
  'Maps radiance to what a screen can show.': '把光亮映射到屏幕可显示的范围。',
  Output: '输出',
  'The image that is displayed and saved.': '屏幕显示与保存的画面。',
  'Save image': '保存图像',
  'Requests that the image is saved as a picture of one moment, seen by the project’s observer, and passes it through. The node’s button downloads it; “slowlight render PROJECT” without -o writes it.':
    '将输入的图像写成某一时刻的图片，由项目的观察者所见，并原样传出。节点上的按钮可下载；不带 -o 的 “slowlight render PROJECT” 会写出文件。',
  'Save video': '保存视频',
  'Requests that the image is saved over a time range, as a film or one file per frame, and passes it through. The node’s button downloads it; “slowlight render PROJECT” without -o writes it.':
    '将输入的图像随时间写成影片，或每帧一个文件，并原样传出。节点上的按钮可下载；不带 -o 的 “slowlight render PROJECT” 会写出文件。',
  Number: '数值',
  'A number for several inputs.': '供多个输入共用的数值。',
  Vector: '向量',
  'A vector of three numbers.': '由三个数值组成的向量。',
  Separate: '分量',
  'The components of a vector or a colour.': '向量或颜色的三个分量。',
  Colour: '颜色',
  'A colour for several inputs.': '供多个输入共用的颜色。',
  Text: '文本',
  'A text for several inputs.': '供多个输入共用的文本。',
  Math: '数学运算',
  'An arithmetic operation; includes conversion between a speed β and its Lorentz factor γ.':
    '一步运算；也可在速度 β 与洛伦兹因子 γ 之间换算。',
  Compare: '比较',
  '1 if the relation holds, otherwise 0.': '关系成立为 1，否则为 0。',
  Switch: '切换',
  'One of two inputs, of any type. The other is not evaluated.': '在两个任意类型的输入中选择一个；另一个不会被计算。',
  Reroute: '转接点',
  'A bend in an edge, to keep it clear of others.': '连线的转折点，使连线更清晰。',
  Group: '节点组',
  'Several nodes as one, which can be used any number of times.': '把多个节点当作一个节点，可多次使用。',
  'Group input': '组输入',
  'The inputs of the group.': '进入节点组的内容。',
  'Group output': '组输出',
  'The outputs of the group.': '节点组输出的内容。',
  'Vector math': '向量运算',
  'A vector operation. If the result is a vector, the number output is its length; if it is a number, all three components equal it.':
    '一步向量运算。结果为向量时，数值是其长度；结果为数值时，向量的三个分量都等于它。',
  Box: '长方体',
  'A box centred at the origin.': '以原点为中心的长方体。',
  Sphere: '球',
  'A sphere around the origin.': '以原点为球心的球。',
  Cylinder: '圆柱',
  'A closed cylinder or cone, centred at the origin.': '以原点为中心的封闭圆柱或圆锥。',
  Torus: '圆环',
  'A torus around an axis through the origin.': '绕过原点的轴的圆环。',
  Grid: '网格平面',
  'A flat rectangle of cells, visible from both sides.': '由格子组成的平面矩形，两面可见。',
  Lattice: '晶格',
  'Bars along the edges of cubes: straight lines show relativistic distortion best.':
    '沿立方体棱的杆：直线最能显示高速下的弯曲。',
  Transform: '变换',
  'Rotates, scales and translates the input, with its motions, lamps and cameras.':
    '旋转、缩放并移动所有输入的物体，连同其运动、灯和相机。',
  Instances: '实例',
  'Copies that share their meshes, in rows or around a circle.': '共享网格的副本，成行排列或绕圆排列。',
  Material: '材质',
  'The material of a surface, including ultraviolet and infrared.': '表面的材料，包括紫外与红外反射。',
  Subdivide: '细分',
  'Splits triangles into four, or makes a smooth surface from them. Not needed for rendering, which tessellates edges for each picture.':
    '把三角形一分为四，或生成光滑曲面。画面本身不需要细分：每幅画面都会自动细分边。',
  Merge: '合并',
  'Merges several inputs. Duplicate names get a number.': '把多个物体合在一起；重复的名称会加上编号。',
  Lifetime: '寿命',
  'Objects and lights exist only within this time range, and there only when they already did.':
    '物体和光源只在此时间段内存在，并且只在其中它们原本存在的时候。',
  Motion: '运动',
  'Moves objects, lights and cameras that are at rest, all as one body. Ride a camera to see what it sees.':
    '让静止的物体、灯光和相机作为一个整体运动。乘坐相机即可看到它所见的画面。',
  'Times are': '时间为',
  'through the samples of a moving camera: smooth, so that the velocity does not jump at them, or in straight lines':
    '如何经过运动相机的各个采样点：smooth 为平滑曲线，速度在采样点处不跳变；straight 为直线段',
  '{}: a smooth path through its {} samples, up to {} beside the straight lines between them (--camera-path straight)':
    '{1}：沿平滑路径经过其 {2} 个采样点，与采样点间的直线相距最多 {3}（--camera-path straight 保留直线）',
  '{}: its velocity still jumps at {}: no curve there is slower than light':
    '{1}：其速度在 {2} 仍有跳变：那里没有慢于光的曲线',
  'The flight is faster than pictures can show: they are drawn as at γ = {}. Place and clocks go on exactly.':
    '飞行速度超出画面所能显示的范围：画面按 γ = {1} 绘制。位置和时钟仍精确推进。',
  'One flies through walls and ground again: {}': '现在又会穿过墙面和地面：{1}',
  'Smooth path': '平滑路径',
  'The ride goes through the camera’s keyframes on a curve, so that your velocity does not jump there, and with it all that you see. Off: along straight lines.':
    '乘坐时沿曲线经过相机的关键帧，你的速度以及所见的一切在那里不会跳变。关闭：沿直线段。',
  'Proper: of the clock of the observer, who rides a moving camera, coasts, or flies a flight.':
    '固有时：观察者所带时钟的时间；观察者乘坐运动的相机、滑行，或沿飞行记录飞行。',
  'A recorded flight, .flight.json: all of it is filmed, instead of what the camera sees.':
    '一段飞行记录，.flight.json：拍摄其全程，而不是相机所见。',
  'frames in proper time need an observer who moves: let him ride a moving camera with its own velocity, or coast without staying in place':
    '按固有时取帧需要运动的观察者：请乘坐运动的相机并使用其自身速度，或不固定位置地滑行',
  "the observer's clock never shows {} s: he is as fast as light": '观察者的时钟永远不会显示 {1} s：他与光一样快',
  '--spacing is for several frames: add --frames FIRST:LAST': '--spacing 用于多帧：请添加 --frames FIRST:LAST',
  'it moves already and keeps its own motion; only cameras at rest are moved':
    '它已在运动，保持自身的运动；只有静止的相机会被带动',
  'Uniform motion': '匀速运动',
  'Constant velocity along a straight line, for all time.': '以恒定速度沿直线运动，无始无终。',
  'Hyperbolic motion': '双曲运动',
  'Constant proper acceleration: approaches c but never reaches it.': '固有加速度恒定：不断接近光速，永不达到。',
  'Circular motion': '圆周运动',
  'Around a circle at constant speed.': '以恒定速率绕圆运动。',
  Spin: '自转',
  'Rotates around an axis.': '绕轴转动。',
  Path: '路径',
  'Along a smooth curve through points, at constant speed.': '以恒定速率沿经过各点的光滑曲线运动。',
  Keyframes: '关键帧',
  'Through positions at given times, with linear interpolation of position and rotation.':
    '在给定时刻到达各处，直线移动，均匀转动。',
  Sun: '太阳',
  'A distant light with a single direction.': '来自远方、方向一致的光。',
  Lamp: '灯',
  'A light at a position, which may move. Squares and discs emit towards their −Z.':
    '位于某处、可运动的灯。矩形与圆盘朝其 −Z 方向发光。',
  Sky: '天空',
  Spectrum: '光谱',
  'The spectrum of a light.': '光的成分。',
  'A camera at rest.': '一个静止的观察位置。',
  Observer: '观察者',
  'The observer’s velocity when the scene is opened.': '打开场景时观察者的速度。',
  'The time range in which the scene is shown.': '场景显示的时间段。',
  'Write USD': '写出 USD',
  'Requests that the geometry is written as USD, and passes it through. The node’s button downloads it; “slowlight render PROJECT” without -o writes it.':
    '将输入的几何体写成 USD，并原样传出。节点上的按钮可下载；不带 -o 的 “slowlight render PROJECT” 会写出文件。',
  'Solid text': '立体文字',
  'Extruded letters that stand on the ground and face +z, in any number of lines: Latin, Greek, Cyrillic, Chinese. Letters have their own widths; there is no kerning.':
    '立在地面、面向 +z 的立体文字，可分多行：拉丁、希腊、西里尔字母与汉字。各字按自身宽度排列，不做字偶距调整。',
  'Mass spring': '质点弹簧',
  'Objects as mass–spring nets: each point has a share of the mass, and springs run along edges, across faces and to second neighbours. For cloth and elastic solids. Coincident points are merged.':
    '把物体变为弹簧网：每个点分得一份质量，弹簧沿边、跨面、并连到隔一个的点。用于布料和弹性体。同一位置的点算一个点。',
  Collider: '碰撞体',
  'Solids that nothing penetrates: infinite planes, boxes, and spheres, which can be free to be moved by contact. Animated objects keep their motion whatever they hit.':
    '不可穿入之物：无限平面、长方体，以及可自由运动、受碰撞推动的球。本身在运动的物体照常运动，不受碰撞影响。',
  Field: '场',
  'Fields that act on everything simulated; several are added. Electric and magnetic fields act on charges.':
    '作用于一切被模拟之物；多个场相加。电场与磁场作用于电荷。',
  Cache: '缓存',
  'Reads a simulation’s results from a file instead of running it again; without a file the input passes through. “slowlight simulate PROJECT -o FILE” or Write USD writes it.':
    '读取已写出的模拟结果，不再重新计算；未指定文件时原样传递输入。用 “slowlight simulate PROJECT -o FILE” 或“写出 USD”写出。',
  Simulate: '模拟',
  'Computes how matter moves, with momenta as state, so that nothing reaches c, and records energy and momentum. The result moves along cubics between frames. “slowlight simulate PROJECT” does it on the command line.':
    '以动量为状态计算物质的运动，任何东西都达不到 c，并记录能量与动量。帧与帧之间沿三次曲线运动。命令行 “slowlight simulate PROJECT” 同样可用。',
  Flight: '飞行',

  'Go on when unstable': '不稳定时继续',
  'Off: with steps that are too long for an explicit method, the run ends as soon as its energy grows. On: it shows how it explodes, until a point would reach c or go through what is solid.':
    '关：步长超出显式方法的稳定限度时，能量一增长便结束。开：继续下去，显示它如何爆炸，直到某一点将达到 c 或穿过实体。',

  // Interpolation
  Cubic: '三次曲线',

  // Flight
  'At rest': '静止时',
  'In flight': '飞行时',

  // Effects
  Custom: '自定义',
  'Gaussian blur': '高斯模糊',
  'Blurs along one direction; two of them, horizontal and vertical, blur evenly. No light is lost at the edges.':
    '沿一个方向模糊；横竖各一次即为均匀模糊。画面边缘不损失光。',
  'Bilateral filter': '双边滤波',
  'Smooths noise, such as that of ambient occlusion, but not across the edges of objects.':
    '平滑噪点（例如环境光遮蔽的噪点），但不越过物体的边缘。',
  'Sky background': '天空背景',
  'Fills the background with a clear sky; distant objects fade into it. It is at rest in the world and has no Doppler shift.':
    '在没有物体处画晴天的天空；远处的物体渐渐融入其中。它相对世界静止，没有多普勒频移。',
  Sharpen: '锐化',
  'Makes edges steeper; without overshoot there are no halos.': '使边缘更陡；不过冲时不产生光晕。',
  Bloom: '泛光',
  'Light scattered by a lens or an eye. Conserves the total light; there is no threshold.':
    '镜头或眼睛散射的光。画面的总光量不变，也没有阈值。',
  Edges: '描边',
  'Draws lines where luminance changes, at silhouettes and at creases.': '在光变化处、物体边界处和表面转折处画线。',
  Vignette: '暗角',
  'Darkens towards the corners by a power of the cosine of the off-axis angle: 4 is a thin lens.':
    '向四角变暗，按偏离光轴角度余弦的幂：4 次方为薄透镜。',
  Fog: '雾',
  'Fog at rest in the world: attenuates by the path that the light has travelled there, not by the apparent distance.':
    '相对世界静止的雾：按光在世界中走过的路程衰减，而不是按物体看上去的距离。',
  'Distant things fade into': '远处的物体融入',
  'Default: the sky in a sky background, grey to haze in fog. The sky: its colours in the same direction, those of a Sky with a gradient, else of a clear day. All are multiplied by the brightness.':
    '默认：天空背景中为天空，雾中为灰雾到霭。天空：同一方向上天空的颜色，取渐变天空节点的颜色，否则取晴天的颜色。均乘以亮度。',
  Default: '默认',
  'The sky': '天空',
  'Own colour': '自定颜色',
  'Depth of field': '景深',
  'A thin lens carried by the observer: focuses by the distance of an event in the observer’s frame.':
    '观察者携带的薄透镜：按事件在观察者参考系中的距离对焦。',
  'Smooths jagged edges in a finished picture. Place it after Tone Map.':
    '平滑成品画面中硬边的锯齿。宜接在色调映射之后。',
  'Width (σ)': '宽度（σ）',
  'Range of distances': '距离范围',
  'Range of normals': '法线范围',
  Gradient: '渐变',
  'Fades at (0: never)': '融入距离（0：不融入）',
  Strength: '强度',
  Overshoot: '过冲',
  'Scattered light': '散射光',
  Spread: '扩散',
  'By light': '按光',
  'By distance': '按距离',
  'By normals': '按法线',
  'Picture opacity': '保留画面',
  Power: '幂',
  'Corner angle (0: camera)': '角落角度（0：相机）',
  'Mean free path': '平均自由程',
  'Grey to haze': '灰雾到霭',
  'Over the sky': '覆盖天空',
  'In focus at': '对焦距离',
  Aperture: '光圈直径',
  'Minimum contrast': '最小对比度',
  'Search along edges': '沿边搜索',
  'Spread single pixels': '扩散孤立像素',
  'Maximum blur': '最大模糊',

  // Modes of mixing
  Normal: '正常',
  Multiply: '正片叠底',
  Add: '相加',
  Screen: '滤色',
  Overlay: '叠加',
  Difference: '差值',
  Split: '分屏',
  Wipe: '擦除',

  // Sockets
  Below: '下层',
  Above: '上层',
  Value: '值',
  In: '输入',
  Out: '输出',
  'The rest': '其余物体',

  // Operations of vectors
  'A + B': 'A + B',
  'A − B': 'A − B',
  'A times the factor': 'A 乘以系数',
  'A × B (cross product)': 'A × B（叉积）',
  'A normalized': 'A 的单位向量',
  'A · B (dot product)': 'A · B（点积）',
  'Length of A': 'A 的长度',

  // Operations of numbers
  'A × B': 'A × B',
  'A ÷ B': 'A ÷ B',
  'A to the power B': 'A 的 B 次方',
  Minimum: '较小值',
  Maximum: '较大值',
  'Remainder of A ÷ B': 'A ÷ B 的余数',
  'Interpolate from A to B by C': '按 C 从 A 到 B',
  'Clamp A between B and C': '将 A 限于 B 与 C 之间',
  'Square root': '平方根',
  Exponential: '指数',
  'Natural logarithm': '自然对数',
  'Absolute value': '绝对值',
  Round: '四舍五入',
  'Round down': '向下取整',
  Sine: '正弦',
  Cosine: '余弦',
  Tangent: '正切',
  Arcsine: '反正弦',
  Arccosine: '反余弦',
  'Angle of the point (B, A)': '点 (B, A) 的方位角',
  'γ of the speed β': '由速度 β 求 γ',
  'Speed β of γ': '由 γ 求速度 β',

  // False colours
  Off: '关',
  Doppler: '多普勒',
  Light: '亮度',
  Band: '波段',

  // Axes
  X: 'X',
  Y: 'Y',
  Z: 'Z',
  Other: '其他',

  // Motion in written files
  Sampled: '采样',

  // Alignment of letters
  'Start at x = 0': '左端在 x = 0',
  'Centre at x = 0': '居中于 x = 0',
  'End at x = 0': '右端在 x = 0',

  // Arrangements
  'In rows': '成行',
  Circle: '圆周',

  // Material presets
  Leaf: '树叶',
  Skin: '皮肤',
  Asphalt: '沥青',
  Snow: '雪',
  Gold: '金',
  Copper: '铜',

  // Surfaces
  'Same shape': '保持形状',
  Smooth: '光滑',

  // Spectra of lights
  'Daylight (6504 K)': '日光（6504 K）',
  'Daylight, measured (D65)': '实测日光（D65）',
  Candle: '蜡烛',
  'Light bulb': '白炽灯',
  'Blue star': '蓝色恒星',
  'Fluorescent tube': '荧光灯',
  'Triphosphor tube': '三基色荧光灯',
  'White LED': '白光 LED',
  'Sodium street light': '高压钠灯',
  'Sodium lines': '钠谱线',
  Mercury: '汞灯',
  Hydrogen: '氢谱线',

  // Lamps
  Point: '点',
  Ball: '球',
  Square: '方形',
  Disc: '圆盘',

  // Skies
  Even: '均匀',
  Stars: '恒星',

  // Spectra
  Blackbody: '黑体',

  // Pinned points
  None: '无',
  'Upper corners': '上方四角',
  Top: '顶部',
  'Points in a box': '框内的点',
  'Points by number': '按编号',

  // Bodies
  Plane: '平面',

  // Rods
  'Each from its own pivot': '各自悬挂',
  'Each from the one before': '逐个相连',

  // Mechanics
  'Einstein’s': '爱因斯坦',
  'Newton’s': '牛顿',

  // Methods of integration
  'Discrete gradient': '离散梯度',
  'Implicit midpoint': '隐式中点',
  Leapfrog: '蛙跳',
  'Yoshida 4': 'Yoshida 4',
  'Yoshida 6': 'Yoshida 6',
  'Yoshida 8': 'Yoshida 8',
  'Semi-implicit Euler': '半隐式欧拉',
  'Linearly implicit': '线性隐式',
  'Local–global': '局部–全局',

  // Corrections of velocities
  'By the tangent': '切线',
  'By the secant': '割线',
  'By the root': '求根',

  // Pictures
  '{} × {} pixels are too many for the graphics device here, which draws up to {} along each side; make the picture smaller.':
    '{1} × {2} 像素超出了此处图形设备的能力（每边最多 {3}）；请缩小图片。',

  // Projects
  Project: '项目',
  New: '新建',
  'Save project': '保存项目',
  'Save with its files': '连同文件一起保存',
  'Share by a link…': '用链接分享…',
  'Name…': '命名…',
  'Name of the project': '项目名称',
  Unnamed: '未命名',
  'Not saved to a file': '尚未保存到文件',
  'Earlier work': '之前的工作',
  Done: '完成',

  // ———— The page ————
  // The gallery
  Projects: '项目',
  'Graphs of nodes: open one, change it, save it as your own.': '节点图：打开、修改，并保存为自己的项目。',
  'Each shows one relativistic effect.': '每个场景都展示一件眼见才信的事。',
  'No example scenes were found. Open a file of your own.': '没有找到示例场景，请打开自己的文件。',
  'Open now': '当前',

  // Steps to undo
  'open a project': '打开项目',
  rename: '重命名',
  'add a node': '添加节点',
  delete: '删除',
  move: '移动',
  connect: '连接',
  disconnect: '断开连接',
  'bend an edge': '添加转接点',
  duplicate: '复制一份',
  cut: '剪切',
  paste: '粘贴',
  'make a group': '编组',
  ungroup: '取消编组',
  mute: '静音',
  collapse: '折叠',
  arrange: '排列',
  'add a frame': '添加框架',
  note: '注释',
  'open a scene': '打开场景',
  'add missing files': '添加缺少的文件',
  'choose a variant': '选择变体',
  'make it fly': '让它飞',
  'end the flight': '结束飞行',
  'the suggested remedy': '采用建议',

  // Links
  'Share by a link': '用链接分享',
  'The whole project is in the link, after the #. Only people who get the link can see it.':
    '整个项目都在链接中 # 之后的部分。只有得到链接的人才能看到它。',
  Link: '链接',
  Copy: '复制',
  Copied: '已复制',
  'A link cannot contain files, and this project reads some from your device: {}. Save it with its files and send the zip.':
    '链接无法携带文件，而此项目读取了你设备上的文件：{1}。请连同文件一起保存，然后发送该 zip。',

  // Notices
  'Saved {}. It reads files that it does not contain ({}): keep them beside it, or save with its files.':
    '已保存 {1}。它读取的文件不在其中（{2}）：请把它们放在旁边，或连同文件一起保存。',
  'Collecting files…': '正在收集文件…',
  'Its files are {}, more than the {} that the page can pack. Save the project alone, and keep the files beside it.':
    '它的文件共 {1}，超过页面可打包的 {2}。请只保存项目，并把文件放在旁边。',
  'This browser cannot store your work ({}): unsaved changes are lost when the page is closed. Save the project, or free some storage.':
    '浏览器无法保留你的工作（{1}）：关闭页面后，未保存的内容会丢失。请保存项目，或释放存储空间。',
  'The files ({}) are too large to be stored in the browser. After a reload they must be opened again; everything else is kept.':
    '文件（{1}）太大，无法保留在浏览器中。重新加载页面后需再次打开它们；其余内容都会保留。',
  'There is unsaved work from {}: {}.': '有 {1} 未保存的工作：{2}。',
  Restore: '继续',
  'Operation failed': '操作未能完成',
  'The last valid scene is still shown.': '仍显示上一个可用的场景。',
  'Diagnostics for this file: {}. See the Scene panel': '此文件有 {1} 条说明，见“场景”面板',
  'Missing files: {} ({}). What needs them is left out or grey. Drop them on the page, or the folder that contains all of them.':
    '缺少 {1} 个文件（{2}），相关内容不会显示，或显示为灰色。请将这些文件或包含它们的文件夹拖放到页面上。',
  'There are no objects in {}, so only the sky is visible. Check what was exported; the Scene panel may say more.':
    '{1} 中没有物体，因此只能看到天空。请检查导出的内容；“场景”面板可能有更多说明。',
  'Set {} to {}': '将{1}设为 {2}',
  'Clear {}': '清空{1}',
  'Saved {}': '已保存 {1}',
  'This browser cannot encode films of that size. Save frames instead (a name like film.####.png), or save the project and run: {}':
    '此浏览器无法编码该尺寸的影片。请改存逐帧图片（文件名如 film.####.png），或保存项目后运行：{1}',
  'This exceeds the {} that a page can hold. Save the project and run: {}':
    '超过了页面可容纳的 {1}。请保存项目后运行：{2}',
  'Copy the command': '复制命令',
  'The browser could not read the dropped files: {}. Check that they still exist and can be read, or use Project › Open file.':
    '浏览器无法读取拖放的内容：{1}。请确认文件仍在且可读，或使用“项目 › 打开文件”。',
  'The graphics device was lost and has been restarted.': '图形设备曾丢失，现已恢复。',
  'The graphics device keeps failing. Reload the page; if that does not help, update the graphics driver.':
    '图形设备反复出错。请重新加载页面；若仍无效，请更新显卡驱动。',

  // Panels
  Graph: '节点图',
  Node: '节点',
  Controls: '控制',
  Energy: '能量',
  'Back to the default': '恢复默认值',

  // The node graph
  'Show the node graph': '显示节点图',
  'Hide the node graph': '隐藏节点图',
  'Node graph. Tab goes from node to node, arrow keys move them, Shift A adds one, Enter opens the inspector, Ctrl K lists all commands.':
    '节点图。Tab 在节点间移动，方向键移动节点，Shift A 添加，Enter 打开检查器，Ctrl K 列出全部命令。',
  'Overview of the graph': '节点图缩略图',
  'Graph tools': '节点图工具',
  'Groups that are open': '已打开的节点组',
  '{}, node': '节点：{1}',
  '{}, node. Problem: {}': '节点：{1}。问题：{2}',
  on: '开',
  off: '关',
  '{} lines': '{1} 行',
  'Lights: {}': '光源：{1}',
  'Cameras: {}': '相机：{1}',
  'Objects: {} · vertices: {}': '物体：{1} · 顶点：{2}',
  'Lines: {}': '谱线：{1}',
  measured: '实测',
  'Picture of the result of {}': '“{1}”的结果图',
  'Picture of the surfaces that {} rasterized': '“{1}”所绘表面的图',
  'Luminance histogram in stops: the median is {} EV, {} % is above white':
    '光的直方图（以曝光级数计）：半数低于 {1} EV，{2}% 超过白色',
  'Luminance histogram: not measured yet': '光的直方图：尚未测量',
  'Next node; with ⇧ the previous one': '下一个节点；加 ⇧ 为上一个',
  'Move the selection; with ⇧ farther': '移动所选；加 ⇧ 移得更远',
  'Clear the selection; then leave the group': '取消选择；再按则离开节点组',
  'new': '新建',
  muted: '已静音',
  'waits for an upstream node': '等待前面的节点',
  driven: '由连线驱动',
  '+ {} more set': '另有 {1} 项已设置',
  'No results': '没有此名称的项',
  Inputs: '输入',
  'Connect to…': '连接到…',
  Disconnect: '断开连接',
  'Title of the frame': '框架标题',
  Frame: '框架',
  'Empty note': '空注释',
  'Add a node…': '添加节点…',
  Delete: '删除',
  Duplicate: '复制一份',
  Cut: '剪切',
  Paste: '粘贴',
  'Select all': '全选',
  'Open the inspector': '打开检查器',
  Rename: '重命名',
  Mute: '静音',
  Collapse: '折叠',
  'Make a group': '编组',
  Ungroup: '取消编组',
  'Enter the group': '进入节点组',
  'Leave the group': '离开节点组',
  'Frame around the selection': '为所选添加框架',
  'Add a note': '添加注释',
  'Pictures on nodes': '节点图像预览',
  Arrange: '自动排列',
  'Align left edges': '左对齐',
  'Align right edges': '右对齐',
  'Align tops': '顶部对齐',
  'Align bottoms': '底部对齐',
  'Align centres': '水平居中对齐',
  'Align middles': '垂直居中对齐',
  'Space evenly across': '水平均匀分布',
  'Space evenly down': '垂直均匀分布',
  'Enlarge or restore': '放大面板，或还原',
  'Fit all': '显示全部',
  'Fit the selection': '显示所选',
  'Zoom in': '放大',
  'Zoom out': '缩小',

  // The command palette
  'Search commands and nodes': '搜索命令与节点',
  Program: '程序',
  'Add: {}': '添加：{1}',

  // The inspector
  'Select a node in the graph to see its parameters here.': '在节点图中选择一个节点，其参数将显示在此。',
  'not connected': '未连接',
  'No matching output': '没有可用的来源',
  'Name of the socket {}': '接口 {1} 的名称',
  'Remove the socket': '移除接口',
  'Draw an edge to “new” to add a socket.': '将连线拖到“新建”即可添加接口。',

  // Categories of nodes
  Geometry: '几何',
  Dynamics: '动力学',
  Composition: '组成',
  Render: '渲染',
  Utility: '工具',
  Groups: '节点组',

  // Types of sockets
  Matter: '物质',
  'Run record': '账目',
  Lights: '光源',
  Relativity: '相对论',
  'G-buffer': 'G 缓冲',
  Image: '图像',
  Picture: '画面',
  Pattern: '图案',
  Mask: '遮罩',

  // The page
  Slowlight: 'Slowlight 慢光',
  'Skip to the picture': '跳到画面',

  // The header
  Scenes: '场景',
  'Open file…': '打开文件…',
  'Open folder…': '打开文件夹…',
  Undo: '撤销',
  'Undo: {}': '撤销：{1}',
  Redo: '重做',
  'Redo: {}': '重做：{1}',
  'Save picture': '保存图片',
  'Keys and help': '按键与帮助',
  'Dark colours': '深色界面',
  'Light colours': '浅色界面',

  // Motion
  'Make something fly': '让物体飞起来',
  'Search objects…': '搜索物体…',
  'No object has this name': '没有此名称的物体',
  'Move as in the file again': '恢复文件中的运动',
  '{} ({} objects)': '{1}（{2} 个物体）',

  // Relations
  'A < B': 'A < B',
  'A ≤ B': 'A ≤ B',
  'A > B': 'A > B',
  'A ≥ B': 'A ≥ B',
  'A = B': 'A = B',
  'A ≠ B': 'A ≠ B',

  // Legends of false colours
  Legend: '图例',
  'Doppler factor D': '多普勒因子 D',
  'Happened, from now': '发生时间（相对现在）',
  'Luminance before exposure': '曝光前的亮度',
  'Seen at 550 nm, emitted at [nm]': '550 nm 处所见光的发射波长 [nm]',
  'Colours from {} to {}': '颜色范围：{1} 至 {2}',
  'Value at the crosshair': '十字线处的数值',
  'Point at the picture, or press P': '指向画面，或按 P 键',
  'Touch the picture': '触摸画面',
  'nothing there': '此处无物体',
  sky: '天空',

  // Tools over the picture
  'Inspect what is seen': '查看所见之物',
  'Measure lengths': '测量长度',
  'Seems faster than light, but is not': '看似超光速，其实不然',
  'Choose a point: click, or press Enter for the middle of the picture': '选取一点：点击，或按 Enter 选取画面中心',
  'This cannot be measured: its motion stays in its file': '无法测量：其运动数据留在文件中',
  'Nothing is there': '此处没有物体',
  'Choose the other point': '选取另一点',
  Lengths: '长度',
  'Light left': '光发出于',
  '{}, {} ago': '{1}，{2} 前',
  'Its own clock then': '当时其自身时钟',
  'Distance then': '当时距离',
  'Distance now': '现在距离',
  unknown: '未知',
  'Relative to you': '相对于您',
  'Seems to move across': '视横向速度',
  'Seems to approach': '视接近速度',
  'Seems to recede': '视远离速度',
  'Looks turned by': '看上去转过',
  '{}: {} away when its light left, {} relative to you, D = {}, looks turned by {}':
    '{1}：光发出时距离 {2}，相对于您 {3}，D = {4}，看上去转过 {5}',
  'Apparent length': '视长度',
  'Length at your moment': '您此刻的长度',

  // Spectral bands
  'far UV': '远紫外',
  'near UV': '近紫外',
  visible: '可见',
  'near IR': '近红外',
  'thermal IR': '热红外',

  // The status bar
  'Not physical': '非物理',
  Status: '状态',
  'Lorentz factor': '洛伦兹因子',
  'Proper time': '固有时',
  '{} triangles': '{1} 个三角形',
  'error up to {} px': '误差不超过 {1} 像素',
  'reading samples…': '读取采样…',
  'starting…': '启动中…',
  'recovering…': '恢复中…',
  'Forward shading': '前向着色',
  'Deferred shading': '延迟着色',
  'Forward: light is computed while surfaces are drawn. Deferred: of a G-buffer, which ambient occlusion and effects read. Click: always deferred.':
    '前向：绘制表面时就计算光照。延迟：由 G 缓冲计算，环境光遮蔽和效果都读取它。点击：始终使用延迟着色。',

  // Locks
  Look: '观察',
  Fly: '飞行',
  'You move and see the effects of your velocity.': '你在运动，并看到速度带来的效应。',
  'You have a velocity but stay in place.': '你有速度，但停在原处。',
  'You move, but the picture is that of someone at rest.': '你在移动，但画面如同静止者所见。',
  Lock: '锁定',

  // Cruise
  Cruise: '巡航',
  'Keep the velocity when you do not steer': '不操纵时保持速度',

  // The timeline
  Timeline: '时间轴',
  Play: '播放',
  Pause: '暂停',
  Loop: '循环',
  'Back to the start': '回到开头',
  'World time': '世界时间',
  'Time goes on without an end in this scene': '此场景的时间没有终点',
  'Nothing moves in this scene': '此场景没有运动',

  // The viewport
  'Picture. W A S D Q E fly, arrow keys look around, Tab changes the lock, Escape leaves the picture.':
    '画面。W A S D Q E 飞行，方向键转头，Tab 切换锁定，Escape 离开画面。',
  Panels: '面板',
  'Look around by turning the device': '转动设备以环顾',
  'How the device is held is told to pages of https and of the device itself alone.':
    '只有经 https 或来自本机的页面才能得知设备的姿态。',
  'The system does not tell this page how the device is held.': '系统不向本页面提供设备的姿态。',
  'This device does not tell how it is held.': '此设备不提供自身的姿态。',
  'Pictures per second': '每秒画面数',
  'As the screen': '与屏幕相同',
  'At most {}': '最多 {1}',
  'Flight controls': '飞行控制',
  Rise: '上升',
  Sink: '下降',
  'Thrust pad: drag up to accelerate forwards; beyond its rim at full speed':
    '推力盘：向上拖动即向前加速；拖出边缘则全速',
  Throttle: '油门',
  'Speed that is held': '保持的速度',
  '{} is not there at this moment.': '{1} 此刻不在那里。',
  'Fly there': '飞到那里',
  'Follow it': '跟随它',
  'Hold what you see': '定住所见',
  'Hide the outside view': '隐藏外部视图',
  'Show the outside view': '显示外部视图',
  'Show the panels': '显示面板',
  'Thrust pad': '推力盘',
  'Accelerate; beyond its rim at full speed': '加速；拖出边缘则全速',
  Slider: '滑块',
  'Keep a speed, or a thrust, without a finger': '无需手指即保持速度或推力',
  Tap: '轻点',
  'Rest a finger': '手指停住',
  'Menu of what is there': '该处事物的菜单',
  'Spread two fingers': '两指张开',
  'Zoom: the field of view': '缩放：视场角',
  'Lock, cruise, way of flying': '锁定、巡航、飞行方式',
  'Right click': '右键单击',
  'Menu of what is there (also the menu key)': '该处事物的菜单（也可按菜单键）',
  'Picture. Drag to look around, tap to inspect, rest for a menu; spread two fingers to zoom.':
    '画面。拖动环顾，轻点查看，停住打开菜单；两指张开缩放。',
  'Drag to look around, fly with the pad': '拖动环顾，用推力盘飞行',
  'You have left the scene.': '你已离开场景。',
  'Look at yourself and the world from outside': '从外部观看自己与世界',
  'Outside view': '外部视图',
  Capture: '捕获',
  Texels: '纹素',
  'Draws what surrounds the observer once, as he would see it at rest, and takes from it what he sees at any velocity and in any direction: the surfaces and their events are the same. Light is computed anew. While he moves, what is near, and what moves itself, is drawn as ever. Use Relativity rasterize for it.':
    '把观察者周围的一切按他静止时所见绘制一次，再从中取得他以任意速度、朝任意方向所见：表面及其事件都相同，光则重新计算。他移动时，近处的物体和自身运动的物体照常绘制。请与“相对论光栅化”一起使用。',
  'Side of each of the six faces. Behind a fast observer directions are spread apart, and a texel covers several pixels. 0: as fine as the picture.':
    '六个面各自的边长。在快速观察者的后方，方向被拉开，一个纹素会覆盖多个像素。0：与画面同样精细。',
  'Greatest error': '最大误差',
  'When anything would be farther beside its place in the picture because the observer has moved, it is drawn anew.':
    '如果观察者移动后，有任何东西偏离其在画面中的位置超过此值，就重新绘制。',
  Shows: '显示内容',
  'The world now': '此刻的世界',
  'What is seen': '看到的东西',
  Nearer: '靠近',
  'The world from outside. Arrow keys turn it, + and − come nearer and go away.':
    '从外部看到的世界。方向键转动，+ 与 − 靠近和远离。',
  'You, and how far you come from ring to ring': '你，以及光从一环到下一环时你前进的距离',
  'Rings: {} s of light apart': '圆环：间距为光走 {1} 秒的路程',
  'Contours of what is seen, where it was': '轮廓线：所见之物当时所在之处',
  'Contours of the world now': '轮廓线：此刻的世界',
  Inset: '小窗',
  'Looks at the world from outside, from beside the observer or from a fixed place: as it is now, or where all that he sees was when its light left. It follows the observer live. The effect “Observer and light rings” draws him.':
    '从外部观看世界，可在观察者旁边或固定的位置：显示世界此刻的样子，或观察者所见的一切在光离开时的所在。它实时跟随观察者。效果“观察者与光环”把他画出来。',
  'The world now: where everything is at this moment of the world’s clocks. What is seen: each point where it was when the light left that the observer sees now.':
    '此刻的世界：按世界时钟，一切此刻所在之处。看到的东西：每一点都在观察者此刻所见的光离开它时的位置。',
  Distance: '距离',
  Azimuth: '方位角',
  '0: behind one who looks ahead. Positive: to the right of him.': '0：在向前看的人身后。正值：在他右侧。',
  Elevation: '仰角',
  'Follows the observer': '跟随观察者',
  'Off: it stays where it is, and looks at a place of the world.': '关闭：它停在原处，注视世界中的一个位置。',
  'Observer and light rings': '观察者与光环',
  'In a picture from outside: where the observer is, how far he comes while light goes from one ring to the next, and rings on which all is that he sees that many seconds old.':
    '用于外部视图：观察者所在之处，光从一环走到下一环时他前进的距离，以及圆环：环上的一切，他看到的是相应秒数之前的样子。',
  'Rings every': '圆环间隔',
  'Opacity of the rings': '圆环不透明度',
  'Size of the observer': '观察者大小',
  'Hold what you see, and walk about in it': '定住所见，并在其中走动',
  'What you see is held still: walk about in it.': '所见已定住：可在其中走动。',
  '{} m from your eye': '离你的眼睛 {1} 米',
  'Back to your eye': '回到你的眼睛',
  'Turn back': '掉头',
  'Fly with W A S D, drag to look, ? for all keys': 'W A S D 飞行，拖动环顾，? 查看全部按键',
  'What to look for': '观察要点',
  More: '展开',
  Less: '收起',
  Hide: '隐藏',
  'Opening {}': '正在打开 {1}',
  Simulating: '正在模拟',
  Stop: '停止',
  'Stopped: interim results are shown.': '已停止：显示目前的结果。',
  'Go on': '继续',
  'Preparing the picture…': '正在准备画面…',
  Cancel: '取消',
  'The graphics device was lost. Restarting…': '图形设备丢失，正在重新启动…',
  'Drop a scene, a project, a folder or a zip; or missing files of the scene':
    '拖放场景、项目、文件夹或 zip；也可补充场景缺少的文件',

  // Stages of loading
  'Reading the file': '读取文件',
  'Building the scene': '构建场景',
  'Tracing light': '追踪光线',
  'Computing steps': '逐步计算',

  // Energy
  'Nothing has been simulated yet. A Simulate node needs matter (Mass Spring, Collider, Field), and its geometry must lead to the output. If something is wrong, the node reports it.':
    '尚无模拟结果。模拟节点需要连接运动的物体（质点弹簧、碰撞体、场），其几何须通向输出。如有问题，节点会给出提示。',
  'Not computed, because it does not lead to the picture: {}. Connect its geometry to the scene, with a Transform to see it beside the others.':
    '未计算，因为没有通向画面：{1}。请将其几何连接到场景，可经过变换节点与其他结果并排显示。',
  Quantity: '绘制的量',
  'Change of energy': '能量变化',
  'Drift of energy': '能量漂移',
  'Energy taken by drag': '阻力耗去的能量',
  'Total energy': '总能量',
  'Kinetic energy': '动能',
  'Potential energy': '势能',
  'Fastest point': '最快的点',
  Momentum: '动量',
  'Angular momentum': '角动量',
  'Logarithmic (absolute values)': '对数坐标（绝对值）',
  '{} over time': '{1}随时间的变化',
  Run: '模拟',
  Drift: '漂移',
  'The largest change of the energy and what drag took together, relative to the largest kinetic energy: the method’s error. – where moving objects, or drag on a graphics processor, hide it':
    '能量与阻力耗去的能量之和的最大变化，相对于最大动能：方法的误差。在运动物体或图形处理器上的阻力使其无从得知时为 –',
  Fastest: '最快',
  'h = {} ms': 'h = {1} ms',
  'adaptive h': '自适应步长',
  Newtonian: '牛顿力学',
  'computed until {}': '已计算到 {1}',
  'stopped at {}': '停止于 {1}',
  'drag took {} J': '阻力耗去 {1} J',
  'Ended at {}: {}': '结束于 {1}：{2}',

  // The scene
  Objects: '物体',
  'Pieces that take turns': '依次出现的部分',
  Triangles: '三角形',
  Moving: '运动物体',
  '{} at t = {}': '{1}，t = {2}',
  'Time range': '时间范围',
  'Paths between samples': '采样之间的路径',
  'accurate to {}': '误差不超过 {1}',
  exact: '精确',
  Diagnostics: '读取说明',
  'No scene is open.': '没有打开的场景。',

  // Files of the scene
  'Scene in these files': '这些文件中的场景',
  none: '无',
  '<{}> is not an absolute path': '<{1}> 不是绝对路径',
  'Missing files': '缺少的文件',
  'for {}': '用于 {1}',
  'searched {}': '查找过 {1}',
  'Add missing files…': '添加缺少的文件…',
  'Or drop them on the page. The scene is then reloaded; you stay where you are.':
    '也可拖放到页面上。场景会重新读取，视角保持不变。',

  // Keys and help
  Keys: '按键',
  Flying: '飞行',
  'Node graph, while it has the focus': '节点图（焦点在图中时）',
  'Accelerate; release to brake': '加速；松开则刹车',
  'Down, up': '下降、上升',
  'Full speed': '全速',
  'Look around (also the arrow keys)': '环顾（也可用方向键）',
  'Capture the mouse; Esc releases it': '锁定鼠标；Esc 释放',
  'Next lock: free, look, fly': '下一个锁定：自由、观察、飞行',
  'Cruise: keep the velocity': '巡航：保持速度',
  'Back to the start of the scene': '回到场景起点',
  'Stop, and turn back to the scene': '停下并转向场景',
  Touch: '触摸',
  'Look around': '环顾',
  'The bar below': '下方状态栏',
  'Play or pause': '播放或暂停',
  'Next view': '下一个视图',
  'Next false colour': '下一种伪彩色',
  'Only the picture': '只显示画面',
  'Leave the picture': '离开画面',
  Drag: '拖动',
  'Double-click': '双击',

  // Names of keys
  Space: '空格',
  Esc: 'Esc',

  // Closing
  Close: '关闭',

  // Saving
  'Download the file': '下载文件',
  'Making {}': '正在生成 {1}',

  // Without graphics
  'Slowlight needs WebGPU or WebGL 2': 'Slowlight 需要 WebGPU 或 WebGL 2',
  'This browser offers neither, so nothing can be rendered. One of these usually helps:':
    '此浏览器两者都不支持，无法绘制画面。通常可以这样解决：',
  'Use a current Chrome, Edge, Firefox or Safari.': '使用最新的 Chrome、Edge、Firefox 或 Safari。',
  'Turn on “Use graphics acceleration when available” in the browser’s system settings, then restart it.':
    '在浏览器的系统设置中打开“使用图形加速（如可用）”，然后重启浏览器。',
  'Update the graphics driver.': '更新显卡驱动。',
  'Or render without a screen: slowlight render scene.usda -o picture.png':
    '或不用屏幕直接渲染：slowlight render scene.usda -o picture.png',
  'Try again': '重试',

  // ———— Views and settings ————
  'what is seen': '所见',
  'What you see': '你所看到的',
  'the world with infinite c': '光速无穷大的世界',
  'positions at one instant of the observer': '观察者某一时刻的位置',
  'positions at your own instant (a “god’s eye” view)': '你此刻同时面上的物体位置（“上帝视角”）',
  Between: '之间',
  'between positions at one instant and what is seen': '介于某一时刻的位置与所见之间',
  'what lies between that instant and what you see': '介于该时刻与你所见之间的过渡',
  'From slice to cone': '从同时面到光锥',
  '0: everything at your own instant. 1: everything as long ago as its light took to you. Between, as long ago as this share of that time.':
    '0：一切都处于你此刻的同时面上。1：一切都处于其光出发到达你的那个时刻。两者之间：只早这段时间的这一比例。',
  'of the view slice-to-cone: 0 your own instant, 1 what is seen': '用于视图 slice-to-cone：0 为你此刻，1 为所见',
  coneSlope: '圆锥斜率',
  'as if light arrived instantaneously': '如同光瞬间到达',
  "use directions of the world frame instead of the observer's": '采用世界参考系中的方向，而不是观察者的',
  'strength of the Doppler shift of colours': '颜色的多普勒频移的强度',
  'strength of the effect of the Doppler shift on brightness': '多普勒频移对亮度影响的强度',
  'no shadows of suns and lamps, for comparison': '不画太阳和灯的阴影，以供比较',
  'exposure compensation, added to the metered exposure: the picture is 2^EV times as bright':
    '曝光补偿，加在测光结果之上：画面亮度为原来的 2^EV 倍',
  "automatic: exposure from the picture's light; resting-eye: the exposure of an observer at rest at the same place, so that beaming shows its true strength; manual: --exposure alone":
    'automatic：曝光取自画面的光；resting-eye：采用在同一处静止的观察者的曝光，因而能看到聚束效应的真实强弱；manual：只按 --exposure',
  'tone curve: neutral keeps colours and compresses highlights; agx rolls off like film; linear clips':
    '色调曲线：neutral 保持颜色并压缩高光；agx 像胶片一样柔和过渡；linear 直接截断',
  'solver for events on the light cone or in the slice of simultaneity; newton: for comparison':
    '求光锥上或同时面上事件的解法；newton 用于比较',
  '--solver newton is for --prim: a pixel is probed by a ray, which needs no solver':
    '--solver newton 用于 --prim：像素由光线探测，不需要解法',
  'iterations of the Newton solver': '牛顿解法的迭代次数',
  'step length of the Newton solver, 0 < k ≤ 1': '牛顿解法的步长因子，0 < k ≤ 1',
  'one sample at the centre of every pixel, for comparison; excludes --samples':
    '每个像素只在中心采样一次，以供比较；不能与 --samples 同用',
  'draw the reference grid on the ground, which is not affected by relativity':
    '在地面上画参考网格，它不受相对论效应影响',
  'of raster: draw the contours of another view over the picture': '用于 raster：在画面上叠画另一视图的轮廓',
  "of raster: in slices of the observer's time, draw apart what is in the world's past and in its future":
    '用于 raster：在观察者时刻的同时面中，区分属于世界过去与未来的部分',
  'a ghost, and past and future apart, are drawn by the rasterizer only: switch them off':
    '重影以及过去与未来的区分只能由光栅渲染器绘制：请将其关闭',
  "of raster: radius of ambient occlusion [m]; 0: none (default: a quarter of the scene's size)":
    '用于 raster：环境光遮蔽的作用距离 [m]；0：无（默认：场景尺寸的四分之一）',

  // ———— Clocks ————
  'Says what clocks of the observer, of the world and of objects show: as seen, in the observer’s slice of simultaneity, and at his world time; and at what rates.':
    '列出观察者、世界和物体的时钟读数：所见的、观察者同时面上的，以及其世界时间处的；并列出各自的快慢。',
  'an object whose clock is read, with those below it; repeatable (default: what moves, else everything; the first 12 things)':
    '读取其时钟的物体，连同其下的物体；可重复（默认：运动的物体，没有则全部；前 12 个）',
  "the observer is the pilot of a recorded flight, NAME.flight.json, and --time the pilot's time from its beginning (default: its end)":
    '观察者是所录飞行（NAME.flight.json）的驾驶员，--time 为从飞行起点算起的驾驶员时间（默认：飞行终点）',
  '{} clocks are too many; choose up to {} by --prim': '{1} 个时钟太多；请用 --prim 选择至多 {2} 个',
  'observer: world time {} s, own clock {} s, at {} m': '观察者：世界时间 {1} s，自身时钟 {2} s，位于 {3} m',
  ship: '飞船',
  world: '世界',
  'clock [s]': '时钟 [s]',
  'as seen': '所见',
  'rate (D)': '快慢（D）',
  'in the slice': '同时面上',
  rate: '快慢',
  'at world time': '同一世界时间',
  Clocks: '时钟',
  'Show them in the picture': '在画面中显示',
  'change the marked events': '更改已标记的事件',
  '{} events are marked; remove one first': '已标记 {1} 个事件；请先移除一个',
  'Name of the event {}': '事件 {1} 的名称',
  'Another event has this name': '另一个事件已用此名称',
  'Add the clock of an object': '添加物体的时钟',
  'Add the clock of an object…': '添加物体的时钟…',
  'Nothing is marked: the clock is {}': '没有标记：该时钟{1}',
  'Seen: as light shows it now, with D. Slice: at your moment, in your frame. World: at the world’s moment, by its time. ⚑ marks an event for the stopwatch.':
    '所见：此刻到达的光所显示的，附 D。同时面：你的参考系中你的此刻。世界：世界系的此刻，按世界时间。⚑ 为秒表标记一个事件。',
  Slice: '同时面',
  Ship: '飞船',
  World: '世界',
  'Mark: {}': '标记：{1}',
  'Remove: {}': '移除：{1}',
  'Marked events': '已标记的事件',
  Event: '事件',
  'Its clock': '当地时钟',
  'timelike: one can be at both': '类时：可以先后亲历二者',
  'lightlike: light goes from one to the other': '类光：光从一个到达另一个',
  'spacelike: none can be at both': '类空：无人能亲历二者',
  'they are one event': '是同一事件',
  'World time between': '世界时间之差',
  'Distance in the world': '世界系中的距离',
  'By the ship’s clock': '按飞船时钟',
  'By the clock at both': '按亲历二者的时钟',
  'Between them in your frame': '你的参考系中的时间差',
  'Interval Δx² − c²Δt²': '间隔 Δx² − c²Δt²',
  'Copied {} events': '已复制 {1} 个事件',
  'The browser does not let this page copy': '浏览器不允许此页面复制',
  'Copy as CSV': '复制为 CSV',
  'Copy as JSON': '复制为 JSON',
  'not yet there': '尚未出现',
  'no longer there': '已不存在',
  'behind a horizon': '在视界之后',

  // ———— Command line ————
  // Joins of clauses
  '{}: {}.': '{1}：{2}。',
  '  ({})': ' （{1}）',
  // Language, help and flags
  'Renders, probes and converts scenes as a relativistic observer sees them.':
    '渲染、探测并转换相对论性观察者所见的场景。',
  'output the version number': '显示版本号',
  'language of texts, also after a command (default: LANGUAGE, LC_ALL, LC_MESSAGES or LANG)':
    '界面语言，也可写在命令之后（默认：由 LANGUAGE、LC_ALL、LC_MESSAGES 或 LANG 决定）',
  'display help for command': '显示命令的帮助',
  'Usage:': '用法：',
  'Arguments:': '参数：',
  'Options:': '选项：',
  'Commands:': '命令：',
  'Examples:': '示例：',
  'Exit codes:': '退出码：',
  options: '选项',
  command: '命令',
  'choices: {}, default: {}': '可选：{1}；默认：{2}',
  'choices: {}': '可选：{1}',
  'default: {}': '默认：{1}',
  'print as JSON': '以 JSON 格式输出',
  'of {}: {}': '用于 {1}：{2}',
  // Exit codes
  done: '完成',
  'an internal error': '内部错误',
  'an invalid flag or argument': '选项或参数无效',
  'a file that is missing, damaged, unphysical, or cannot be written': '文件缺失、损坏、不符合物理，或无法写入',
  'no GPU, browser, encoder or port available': '没有可用的 GPU、浏览器、编码器或端口',
  'compare --fail-above: the pictures differ by more': 'compare --fail-above：图像的差异超过所给的值',
  'simulate: the simulation ended early; its result so far is written': 'simulate：模拟提前结束；已写出此前的结果',
  'stopped with Ctrl-C; no incomplete file is left': '已用 Ctrl-C 停止；不会留下不完整的文件',
  // Errors of the command line
  'error: {}': '错误：{1}',
  '({} tells more)': '（详见 {1}）',
  "option '{}' argument '{}' is invalid. {}": '选项“{1}”的值“{2}”无效。{3}',
  'Allowed choices are {}.': '可选的值：{1}。',
  "unknown command '{}'": '未知的命令“{1}”',
  "unknown option '{}'": '未知的选项“{1}”',
  "missing required argument '{}'": '缺少必需的参数“{1}”',
  "option '{}' argument missing": '选项“{1}”缺少值',
  "too many arguments for '{}'": '“{1}”的参数过多',
  'too many arguments': '参数过多',
  '{}. Expected 1 argument but got {}.': '{1}。应有 1 个参数，却给出了 {2} 个。',
  '{}. Expected {} arguments but got {}.': '{1}。应有 {2} 个参数，却给出了 {3} 个。',
  '(Did you mean one of {}?)': '（是否要输入其中之一：{1}？）',
  '(Did you mean {}?)': '（是否要输入 {1}？）',
  "this is a fault of Slowlight's own, please report it:\n{}": '这是 Slowlight 自身的故障，请报告：\n{1}',
  'slowlight: {}': 'slowlight: {1}',
  stopped: '已停止',
  // Diagnostics and progress
  error: '错误',
  warning: '警告',
  info: '提示',
  'frame {}': '第 {1} 帧',
  '{}, {} left': '{1}，还需 {2}',
  'reading …': '正在读取…',
  'getting ready to draw …': '正在准备绘制…',
  'finishing …': '正在收尾…',
  // Values of flags
  'Expected a number.': '应为一个数。',
  'Expected {}.': '应为{1}。',
  'a whole number, {} to {}': '整数，{1} 至 {2}',
  'a number above {}': '大于 {1} 的数',
  'a number above {} and at most {}': '大于 {1} 且不大于 {2} 的数',
  'a number, {} or above': '不小于 {1} 的数',
  'a number from {} to {}': ' {1} 至 {2} 的数',
  'degrees between 0 and 180': ' 0 至 180 之间的度数',
  'a port, 0 to 65535': '端口号，0 至 65535',
  'Expected three numbers, X,Y,Z.': '应为三个数：X,Y,Z。',
  'Its length is {}, and nothing with mass reaches 1 (the speed of light).':
    '其长度为 {1}，而有质量的物体无法达到 1（光速）。',
  'Expected SET=OPTION, as inspect lists them: /World/Car{paint}=red.':
    '应写为 SET=OPTION，如 inspect 所列：/World/Car{paint}=red。',
  'Expected WIDTHxHEIGHT in pixels, like 1280x720.': '应以像素写为 WIDTHxHEIGHT，例如 1280x720。',
  'Expected FROM:TO, two numbers, the smaller one first, like -2:0.': '应写为 FROM:TO，两个数，较小的在前，例如 -2:0。',
  'Expected FIRST:LAST, two whole numbers, like 1:48.': '应写为 FIRST:LAST，两个整数，例如 1:48。',
  'There is no AOV {}; there are {}.': '没有名为 {1} 的 AOV；现有 {2}。',
  'Expected two numbers, X,Y.': '应为两个数：X,Y。',
  'Expected PRIM=X,Y,Z or PRIM=X,Y,Z@T, like /World/Car=0.8,0,0@2.':
    '应写为 PRIM=X,Y,Z 或 PRIM=X,Y,Z@T，例如 /World/Car=0.8,0,0@2。',
  // Scenes and motions
  '{} file; a panorama (a picture or a film); or a .zip with one, set.zip[scene.usda] to choose one of several':
    '{1} 文件；全景（图片或影片）；或含有此类文件的 .zip，有多个时以 set.zip[scene.usda] 选择',
  "select a variant, as listed by inspect: '/World/Car{paint}=red'; repeatable":
    "选择变体，写法如 inspect 所列：'/World/Car{paint}=red'；可重复",
  'glTF: animation to play, by name or index from 0 (default: the first)':
    'glTF：要播放的动画，用名称或从 0 起的序号指定（默认：第一个）',
  'USD: interpolation between time samples; USD specifies linear': 'USD：时间样本之间的插值；USD 规定为线性',
  'USD: subdivision levels; 0 draws the polygons (default: as many as look smooth, fewer if there would be too many faces)':
    'USD：细分级数；0 表示绘制多边形（默认：看上去平滑所需的级数，面数会过多时减少）',
  'factor on the speed of the animation': '动画的速度倍数',
  'delay of the animation [s]; negative: earlier': '动画的延迟 [s]；负值表示提前',
  "make a prim and its descendants move at this velocity in units of c, passing their authored positions at t [s] (default 0): '/World/Car=0.8,0,0@2'; repeatable":
    "使 prim 及其后代以此速度（单位为 c）运动，在 t [s] 时（默认 0）经过文件中的位置：'/World/Car=0.8,0,0@2'；可重复",
  'with --fly: whether the file has the rest shape, or the shape in the world frame while moving':
    '与 --fly 同用：文件中的形状是静止形状，还是运动时在世界参考系中的形状',
  '--fly {}: the scene has no such thing; it has {}': '--fly {1}：场景中没有此物体；现有 {2}',
  '{}: it deforms, and has too many samples to be carried along': '{1}：它会变形，且样本过多，无法随之移动',
  'none of its {} files is a scene': '其中的 {1} 个文件都不是场景',
  'is a folder; name the scene in it': '是文件夹；请指明其中的场景',
  'cannot be read ({})': '无法读取（{1}）',
  'it is not what was opened any more ({}); open the scene again': '它已不是打开时的内容（{1}）；请重新打开场景',
  'it was written to since': '此后曾被写入',
  'it ends before byte {}': '在第 {1} 字节之前就已结束',
  // Observer and camera
  "prim path of the camera (default: the scene's first; if it has none, a view of the whole scene)":
    '相机的 prim 路径（默认：场景的第一个相机；若没有，则取可见整个场景的视图）',
  "the observer's velocity in units of c, world axes (default: the camera's)":
    '观察者的速度，单位为 c，按世界坐标轴（默认：相机的速度）',
  'position of the observer, world frame [m]': '观察者在世界参考系中的位置 [m]',
  'direction of the camera: from its position towards this point, world axes [m]':
    '相机的朝向：从其位置指向此点，按世界坐标轴 [m]',
  "vertical field of view in the observer's frame": '在观察者参考系中的垂直视角',
  'speed of light (default: suggested by the scene, else {})': '光速（默认：场景建议的值，否则为 {1}）',
  '--camera {}: the scene has no such camera; it has {}': '--camera {1}：场景中没有此相机；现有 {2}',
  '--look-at names the place where the camera is: there is no direction to look in':
    '--look-at 指定的正是相机所在之处：没有可看的方向',
  "world time of the observer's event [s] (default: suggested by the scene, else its start)":
    '观察者所在事件的世界时间 [s]（默认：场景建议的时间，否则为其起始时间）',
  // Pipelines and GPUs
  rasterizer: '光栅化器',
  'draws on a GPU': '在 GPU 上绘制',
  'smoothed by FXAA': '以 FXAA 平滑',
  'reference renderer': '参考渲染器',
  'traces rays in 64-bit arithmetic on the CPU, without a GPU': '在 CPU 上以 64 位运算追踪光线，无需 GPU',
  'slower, and exact': '较慢，但精确',
  'needs no GPU and is always exact': '不需要 GPU，且始终精确',
  'number of worker threads (default: that of processors)': '工作线程数（默认：处理器数）',
  'seed of the random numbers; the same seed gives the same bits (default: 0)':
    '随机数的种子；种子相同，结果逐位相同（默认：0）',
  'adaptive sampling: ends where there is little noise, instead of taking --samples everywhere; the standard error that those that get all of them may have, of sRGB values 0 … 1, in an .exr relative to the light (0, the default: off)':
    '自适应采样：噪点少处提前结束，不再处处取满 --samples；数值是取满之处允许的标准误差：以 0 … 1 的 sRGB 值计，.exr 中则相对于光（0 为默认值：关闭）',
  'with --noise-threshold: n × n samples per pixel at least; more find what is small and bright (default: {})':
    '与 --noise-threshold 同用：每像素至少 n × n 个采样；多取些，才不会漏掉又小又亮之物（默认：{1}）',
  "removes what is left of the noise by Open Image Denoise's network: few samples are enough, fine detail of shadows and reflections may be lost":
    '用 Open Image Denoise 的网络去除余下的噪点：少量采样即可，但阴影和反射的细节可能丢失',
  'the grid would be denoised with the picture: switch off the grid, or the denoiser':
    '网格会随画面一起被降噪：请关闭网格，或关闭降噪',
  'number of bounces of light from the sky and from emissive surfaces (default: {})':
    '来自天空和发光表面的光的散射次数（默认：{1}）',
  'smooth surfaces reflect the sky and emissive surfaces, but not each other':
    '光滑表面只反射天空和发光表面，不相互反射',
  'closed transparent objects refract light with the index of refraction of their material':
    '封闭的透明体按其材质的折射率折射光线',
  'auto: {} if possible': 'auto：尽可能用 {1}',
  'webgpu in this process': 'webgpu 在本进程中运行',
  'webgl in a headless Chromium': 'webgl 在无界面的 Chromium 中运行',
  'auto: the first that works': 'auto：第一个可用的',
  '{} is for the {}: add --pipeline {}, or leave it out': '{1} 用于{2}：请加上 --pipeline {3}，或去掉它',
  '{} is for the {}; --pipeline {} {}. Leave one of them out': '{1} 用于{2}；--pipeline {3} {4}。请去掉其中之一',
  'does not have it': '没有此选项',
  '--aov {}: --pipeline {} gives {}': '--aov {1}：--pipeline {2} 只提供 {3}',
  'no usable GPU, so the {} draws: {}.': '没有可用的 GPU，因此由{1}绘制：{2}。',
  'Without a GPU: --pipeline {}.': '没有 GPU 时请用：--pipeline {1}。',
  'a thread of the {} ran out of memory. Use fewer --threads, or let each have more: NODE_OPTIONS=--max-old-space-size=8192 [MiB]':
    '{1}的一个线程内存不足。请减小 --threads，或让每个线程有更多内存：NODE_OPTIONS=--max-old-space-size=8192 [MiB]',
  'a thread of the graph ended by itself, with {}': '节点图的一个线程自行结束，代码为 {1}',
  'the GPU reported: {}': 'GPU 报告：{1}',
  'the device was lost: {}': '图形设备丢失：{1}',
  'the GPU library (npm package webgpu) does not load here: {}': 'GPU 库（npm 包 webgpu）无法在此加载：{1}',
  'no GPU was found, and no software one. On Debian or Ubuntu: apt-get install -y chromium libvulkan1 (Chromium carries the software GPU). Elsewhere set VK_ICD_FILENAMES to the description of a Vulkan driver, or use --backend webgl.':
    '找不到 GPU，也没有软件 GPU。在 Debian 或 Ubuntu 上：apt-get install -y chromium libvulkan1（Chromium 自带软件 GPU）。在其他系统上，请将 VK_ICD_FILENAMES 设为 Vulkan 驱动的描述文件，或使用 --backend webgl。',
  '--backend webgl needs Chromium, which is not on the PATH (CHROMIUM may name it). On Debian or Ubuntu: apt-get install -y chromium libegl-mesa0 libgl1-mesa-dri':
    '--backend webgl 需要 Chromium，而 PATH 中没有（可用 CHROMIUM 指定）。在 Debian 或 Ubuntu 上：apt-get install -y chromium libegl-mesa0 libgl1-mesa-dri',
  'Chromium ({}) does not start: {}': 'Chromium（{1}）无法启动：{2}',
  'the Chromium here has no WebGL2. On Debian or Ubuntu: apt-get install -y libegl-mesa0 libgl1-mesa-dri':
    '此处的 Chromium 没有 WebGL2。在 Debian 或 Ubuntu 上：apt-get install -y libegl-mesa0 libgl1-mesa-dri',
  // render
  'Renders a scene or a project as .png, .exr with data channels, or a film: .mp4 or .gif.':
    '将场景或项目渲染为 .png、带数据通道的 .exr，或影片：.mp4 或 .gif。',
  '{}; or a .slowlight.json project': '{1}；或 .slowlight.json 项目',
  'output file; #### in the name of a .png or .exr is replaced by the frame number (default: the files that the nodes of a project write)':
    '输出文件；.png 或 .exr 文件名中的 #### 由帧号代替（默认：项目的节点所写的文件）',
  'for a project, without -o: folder that its files are written to (default: the current one)':
    '用于项目，且没有 -o：写入文件的文件夹（默认：当前文件夹）',
  'picture size in pixels': '图像的大小，以像素计',
  'first and last frame; frame n is at world time n/fps': '首帧与末帧；第 n 帧的世界时间为 n/fps',
  "frames per second (default: the scene's time codes per second); a .gif has at most 50, of whole hundredths of a second: at 24, four or five each":
    '每秒帧数（默认：场景每秒的时间码数）；.gif 至多 50 帧，每帧为百分之一秒的整数倍：24 帧时每帧百分之四或五秒',
  'with --frames: keep the observer in place instead of moving it with its velocity':
    '与 --frames 同用：让观察者留在原处，而不按其速度移动',
  "where the camera stands, from the observer's eye, on his axes [m]: everything stays as and where he sees it, and is looked at from there":
    '相机相对观察者眼睛的位置（沿其坐标轴，米）：一切保持他所见的样子和位置，从那里观看',
  '{} of {}': '{2} 为 {1}',
  'n × n samples per pixel (default: {})': '每像素 n × n 个采样（默认：{1}）',
  'false colours: the Doppler factor, emission time relative to the observer, luminance before exposure, or the emitted wavelength that is visible':
    '伪彩色：多普勒因子、相对于观察者的发光时刻、曝光前的亮度，或变为可见光的发射波长',
  'values at both ends of the colour scale; emission-time in seconds, band in metres (default: round numbers that enclose the values of the first picture)':
    '色标两端的值；emission-time 以秒计，band 以米计（默认：包含第一幅图像所有值的整齐数）',
  'with --false-colour, --ghost or --past-future: add a legend below the picture':
    '与 --false-colour、--ghost 或 --past-future 同用：在图像下方加图例',
  'for .exr: data channels to write, comma-separated: {}': '用于 .exr：要写入的数据通道，以逗号分隔：{1}',
  'for a project: set a parameter of a node; repeatable; vectors as x,y,z':
    '用于项目：设定节点的参数；可重复；向量写为 x,y,z',
  'print a report as JSON': '以 JSON 格式输出报告',
  '--folder is for the files of a project; -o names its own': '--folder 用于项目的文件；-o 自己指定文件',
  '--output {}: its name must end in {}': '--output {1}：文件名必须以 {2} 结尾',
  '--output {}: several frames need a place for their number, like {}':
    '--output {1}：多帧时文件名须留出帧号的位置，例如 {2}',
  '--size {}x{}: an .mp4 needs an even width and height': '--size {1}x{2}：.mp4 的宽和高须为偶数',
  'a film, .mp4 or .gif, needs --frames FIRST:LAST': '影片（.mp4 或 .gif）需要 --frames FIRST:LAST',
  '--time and --frames exclude each other': '--time 与 --frames 不能同时使用',
  '--no-antialiasing takes one sample, at the centre of each pixel: leave it or --samples out':
    '--no-antialiasing 只在每个像素的中心取一个采样：请去掉它或 --samples',
  '--aov needs a file that can hold data channels: write an .exr, not {}':
    '--aov 需要能保存数据通道的文件：请写为 .exr，而不是 {1}',
  '--false-range is for false colours: add --false-colour, or leave it out':
    '--false-range 用于伪彩色：请加上 --false-colour，或去掉它',
  '--legend is for false colours, a ghost, and past and future: add --false-colour, --ghost or --past-future, or leave it out':
    '--legend 用于伪彩色、重影以及过去与未来：请加上 --false-colour、--ghost 或 --past-future，或去掉它',
  '--legend is below a picture for a screen; an .exr has data instead: leave it out':
    '--legend 位于供屏幕显示的图像下方；.exr 中是数据：请去掉它',
  '--false-colour makes pictures for a screen; an .exr holds the numbers themselves: use --aov':
    '--false-colour 生成供屏幕显示的图像；.exr 保存数值本身：请用 --aov',
  '--false-range: the scale of {} is logarithmic, so that both ends must be above 0':
    '--false-range：{1} 的色标是对数的，两端都必须大于 0',
  '{} files, the last {}': '{1} 个文件，最后一个为 {2}',
  'mp4 needs the program ffmpeg, which is not on the PATH. On Debian or Ubuntu: apt-get install -y ffmpeg':
    'mp4 需要程序 ffmpeg，而 PATH 中没有。在 Debian 或 Ubuntu 上：apt-get install -y ffmpeg',
  '{}: ffmpeg failed: {}': '{1}：ffmpeg 失败：{2}',
  // Projects
  'a .slowlight.json project, or an archive with one': '.slowlight.json 项目，或含有项目的压缩包',
  'set a parameter of a node; repeatable; vectors as x,y,z': '设定节点的参数；可重复；向量写为 x,y,z',
  '--set is for projects, .slowlight.json; of a scene file there are no nodes to set':
    '--set 用于项目（.slowlight.json）；场景文件没有可设定的节点',
  '--set {}: write node.param=value, like console.speedOfLight=10':
    '--set {1}：请写为 node.param=value，例如 console.speedOfLight=10',
  '--set {}.{}: the project has no such node; it has {}': '--set {1}.{2}：项目中没有此节点；现有 {3}',
  '--set {}.{}: a {} has no such parameter; it has {}': '--set {1}.{2}：{3} 没有此参数；现有 {4}',
  '--set {}.{}={}: {}': '--set {1}.{2}={3}：{4}',
  '{} is for scene files; a project says so in its nodes: use --set node.param=value':
    '{1} 用于场景文件；项目由其节点设定：请用 --set node.param=value',
  '--{} is for -o; without it each node that writes says so itself: use --set node.param=value':
    '--{1} 须与 -o 同用；没有 -o 时由写文件的各节点自行设定：请用 --set node.param=value',
  'name the file to write with -o; only projects say by themselves what they write':
    '请用 -o 指定要写的文件；只有项目自己指定所写的文件',
  '{}: it holds no {}; save the project with its files again': '{1}：其中没有 {2}；请重新将项目与其文件一起保存',
  '{}: there is no picture': '{1}：没有图像',
  '{}: it has no output node, so that it makes no picture; add one': '{1}：项目没有输出节点，因此没有图像；请添加一个',
  'there is no such file; put it beside the project': '没有这个文件；请将其放在项目旁边',
  '{}: none of its nodes writes a file; add one that does, or name a picture with -o':
    '{1}：没有写文件的节点；请添加一个，或用 -o 指定图像',
  '{}: not all of its files can be written': '{1}：有文件无法写出',
  'two nodes write {}; give one of them another name': '有两个节点都写 {1}；请为其中一个另起名称',
  // Output files
  '{}: there is no folder {} to write into; make it first': '{1}：没有可写入的文件夹 {2}；请先创建它',
  '{} is a folder; name a file': '{1} 是文件夹；请指定文件',
  '{} is there already and is another file; write into a folder of its own': '{1} 已存在且内容不同；请写入单独的文件夹',
  // diagram
  'Draws as .svg a spacetime diagram of an observer’s event, with world lines, light cone and simultaneity; or energy and momentum over speed.':
    '以 .svg 绘制观察者事件处的时空图，含世界线、光锥和同时面；或绘制能量和动量随速度的变化。',
  'output file, .svg': '输出文件，.svg',
  'what is drawn': '绘制的内容',
  'an object whose world line is drawn, with those below it; repeatable (default: what moves, else everything; the first 12 things)':
    '绘制其世界线的物体，连同其下的物体；可重复（默认：运动的物体，没有则全部；前 12 个）',
  'the frame that is drawn: the world’s, or the observer’s rest frame': '所绘的参考系：世界系，或观察者静止系',
  'direction of the x axis (default: the observer’s velocity; at rest that of the fastest object, else towards the most distant one)':
    'x 轴的方向（默认：观察者的速度方向；静止时取最快物体的速度方向，否则指向最远的物体）',
  'a second direction: the diagram has two dimensions of space': '第二个方向：图中有两个空间维',
  'half the length of the x axis [m] (default: as far as the events that are seen)':
    'x 轴长度的一半 [m]（默认：容纳所见的事件）',
  'colours on a light or a dark ground': '浅色或深色背景上的配色',
  '-o {}: diagrams are written as .svg; the page also saves them as .png': '-o {1}：图以 .svg 写出；页面也可存为 .png',
  '--axis 0,0,0 is no direction': '--axis 0,0,0 不是方向',
  '--second-axis 0,0,0 is no direction': '--second-axis 0,0,0 不是方向',
  '--second-axis lies along --axis: give another direction': '--second-axis 与 --axis 平行：请给出另一方向',
  '--prim {}: the scene has no such thing; it has {}': '--prim {1}：场景中没有该物体；有 {2}',
  '{} world lines are too many; choose up to {} by --prim': '{1} 条世界线过多；请用 --prim 选择至多 {2} 条',
  // Lessons
  Lessons: '课程',
  'Lessons: guided pages beside the picture': '课程：画面旁的引导页',
  'Step {} of {}': '第 {1} 步，共 {2} 步',
  'All lessons': '全部课程',
  'Close lessons': '关闭课程',
  'Each step sets the picture. Say first what you will see, then look.':
    '每一步都会设置画面。先说出你会看到什么，然后再看。',
  '{} steps, about {} minutes': '{1} 步，约 {2} 分钟',
  'The link asks for the lesson “{}”, which is not there. Choose one of the list.':
    '链接要打开课程“{1}”，但没有这个课程。请从列表中选择。',
  'The link asks for step {}; this lesson has the steps 1 to {}. It begins with the first.':
    '链接要打开第 {1} 步；本课程只有第 1 到 {2} 步，现从第一步开始。',
  Back: '上一步',
  Next: '下一步',
  'Start again': '重新开始',
  'Copy link to this step': '复制这一步的链接',
  'Print the lesson': '打印本课',
  'The link is copied: {}': '链接已复制：{1}',
  'Link to this step: {}': '这一步的链接：{1}',
  See: '看一看',
  'Choose an answer first.': '请先选择一个答案。',
  'Right.': '正确。',
  'Not so.': '不是这样。',
  'Right is:': '正确答案：',
  Answers: '答案',
  'step of a lesson': '课程的一步',
  // Diagrams
  Diagram: '图',
  'Kind of diagram': '图的种类',
  Spacetime: '时空',
  'Energy over β': '能量–β',
  'Frame of the diagram': '图的参考系',
  'World’s frame': '世界系',
  'Observer’s frame': '观察者系',
  'Two dimensions of space': '两个空间维',
  'Observer’s velocity: {} c': '观察者的速度：{1} c',
  'Observer’s velocity': '观察者的速度',
  'Objects: {} of {}': '物体：{2} 个中的 {1} 个',
  'Objects of the diagram': '图中的物体',
  'Save SVG': '保存 SVG',
  'Save PNG': '保存 PNG',
  Closer: '放大',
  Farther: '缩小',
  'Show all events': '显示所有事件',
  'Observer’s event in the diagram: arrow keys move it in time and place, plus and minus zoom':
    '图中观察者的事件：方向键移动其时间和位置，加减键缩放',
  'Spacetime diagram': '时空图',
  '{}, now for the observer': '{1}，观察者的此刻',
  '{}, as seen': '{1}，所见',
  'Observer, β = {}': '观察者，β = {1}',
  'Now for the observer': '观察者的此刻（同时面）',
  'Past light cone': '过去光锥',
  'Future light cone': '未来光锥',
  'Emission of the light seen': '所见之光的发出事件',
  'Event of the observer’s now': '观察者此刻的事件',
  'Ticks: {} {} of own time': '刻度：固有时 {1} {2}',
  'Time against place in the frame of the world, about the observer’s event. The observer moves with β = {}.':
    '世界系中以观察者事件为原点的时间—位置图。观察者以 β = {1} 运动。',
  'Time against place in the rest frame of the observer, about the observer’s event. The world moves with β = {}.':
    '观察者静止系中以其事件为原点的时间—位置图。世界以 β = {1} 运动。',
  'World lines: {}. Of {} of {} the observer sees light.': '世界线：{1}。其中 {3} 条中有 {2} 条的光为观察者所见。',
  '{} {} Beside the axis, so that their events lie within the drawn cone: {}.':
    '{1}{2}不在轴上、故其事件位于所绘光锥之内：{3}。',
  'Energy and momentum over β': '能量和动量随 β 的变化',
  'Kinetic energy / mc²': '动能 / mc²',
  'classical: β²/2': '经典：β²/2',
  'Momentum / mc': '动量 / mc',
  'classical: β': '经典：β',
  'Relativistic kinetic energy and momentum grow without bound towards β = 1; the classical ones reach 1/2 and 1.':
    '趋近 β = 1 时，相对论动能和动量无限增长；经典值只到 1/2 和 1。',
  'Relativistic kinetic energy and momentum grow without bound towards β = 1; the classical ones reach 1/2 and 1. Bodies: {}.':
    '趋近 β = 1 时，相对论动能和动量无限增长；经典值只到 1/2 和 1。物体：{1}。',
  // probe
  'Computes in double precision what the observer sees of each vertex of an object, or at a pixel.':
    '以双精度计算观察者所见的物体各顶点，或某一像素处的景物。',
  'prim path of an object: emission time, apparent position and Doppler factor of each vertex':
    '物体的 prim 路径：给出各顶点的发光时刻、视位置和多普勒因子',
  'pixel to probe, from the top left; 0,0 is the centre of the first pixel':
    '要探测的像素，从左上角数起；0,0 为第一个像素的中心',
  'size of the picture that contains the pixel': '像素所在图像的大小',
  'give either --prim or --pixel': '请给出 --prim 或 --pixel 之一',
  '--prim {}: the scene has no such object; it has {}': '--prim {1}：场景中没有此物体；现有 {2}',
  scene: '场景',
  time: '时间',
  speedOfLight: '光速',
  view: '视图',
  observer: '观察者',
  position: '位置',
  beta: '速度 β',
  speed: '速率',
  gamma: '洛伦兹因子',
  pixel: '像素',
  size: '大小',
  width: '宽',
  height: '高',
  seen: '所见',
  prim: 'prim',
  object: '物体',
  velocity: '速度',
  apparent: '视位置',
  distance: '距离',
  doppler: '多普勒因子',
  normal: '法线',
  albedo: '反照率',
  occlusion: '环境光遮蔽',
  inspection: '详查',
  emissionTime: '发光时间',
  emissionPosition: '发光位置',
  properTime: '原时',
  distanceThen: '当时距离',
  distanceNow: '现在距离',
  relativeVelocity: '相对速度',
  apparentSpeedAcross: '视横向速率',
  apparentRadialSpeed: '视径向速率',
  superluminal: '视超光速',
  rotation: '视转角',
  vertex: '顶点',
  'time [s]': '时间 [s]',
  'apparent x': '视位置 x',
  'distance [m]': '距离 [m]',
  true: '是',
  false: '否',
  'behind a horizon: no light of it ever comes here': '在视界之后：它的光永远不会到达这里',
  // inspect
  'Reports the contents of a scene file, its speeds, and its errors.': '报告场景文件的内容、其中的速度以及错误。',
  '{}: an error, told above': '{1}：有一个错误，见上文',
  '{}: {} errors, told above': '{1}：有 {2} 个错误，见上文',
  '{} up, 1 unit = {} m, {} time codes a second, {} … {} s':
    '{1} 轴向上，1 单位 = {2} m，每秒 {3} 个时间码，{4} … {5} s',
  'fastest: {}, {} m/s = {} c{} (c = {} m/s)': '最快：{1}，{2} m/s = {3} c{4}（c = {5} m/s）',
  'nothing moves (c = {} m/s)': '没有运动的物体（c = {1} m/s）',
  ' at {} s': '，在 {1} s',
  ' from {} to {} s': '，从 {1} 到 {2} s',
  'paths between samples are exact': '样本之间的路径是精确的',
  'paths between samples are right to {} m': '样本之间的路径精确到 {1} m',
  '1 object': '1 个物体',
  '{} objects': '{1} 个物体',
  '1 vertex': '1 个顶点',
  '{} vertices': '{1} 个顶点',
  '1 triangle': '1 个三角形',
  '1 material': '1 种材质',
  '{} materials': '{1} 种材质',
  '1 light': '1 个光源',
  '{} lights': '{1} 个光源',
  '1 camera': '1 个相机',
  '{} cameras': '{1} 个相机',
  '1 sample': '1 个样本',
  static: '静止',
  uniform: '匀速',
  hyperbolic: '双曲运动',
  sampled: '采样运动',
  'sampled-points': '逐点采样',
  '{} along cubics': '{1}（沿三次曲线）',
  'distant light': '平行光',
  'sphere light': '球形光源',
  'rect light': '矩形光源',
  'disk light': '圆盘光源',
  'cylinder light': '柱形光源',
  'dome light': '天穹光',
  'a film of {} frames': '{1} 帧的影片',
  'its film is not written, only its first picture': '其影片不写入，只写入第一幅画面',
  'stars light': '星空光',
  'authored at rest': '以静止形状制作',
  'lives {} … {} s': '存在于 {1} … {2} s',
  '{} pieces that take turns': '{1} 个依次出现的部分',
  '{} pieces that take turns, of which the first {} are listed': '{1} 个依次出现的部分，列出其中最前面的 {2} 个',
  'camera, {}, {}° high': '相机、{1}、垂直视角 {2}°',
  // compare
  'Compares two pictures: statistics and an error map.': '比较两幅图像：统计数据与误差图。',
  'test picture: .png, .jpg or .exr': '被测图像：.png、.jpg 或 .exr',
  'reference picture': '参考图像',
  'error metric, see below': '误差度量，见下文',
  'error map, .png': '误差图，.png',
  'with -o: A, B and the error side by side': '与 -o 同用：并排显示 A、B 和误差',
  'with --metric aov: use the differences of this channel for map and fraction':
    '与 --metric aov 同用：误差图和占比取自此通道的差异',
  'error above which a pixel counts as different (default: flip 0.1, pixels 0.02, aov 0.5 px)':
    '误差超过此值的像素视为不同（默认：flip 0.1，pixels 0.02，aov 0.5 px）',
  'exit with code 5 if more than this fraction of the pixels, 0 … 1, is different':
    '不同像素的占比（0 … 1）超过此值时以退出码 5 结束',
  'error shown in the brightest colour of the map': '误差图中最亮颜色所表示的误差',
  'with --triptych: show .exr pictures 2^EV times as bright': '与 --triptych 同用：将 .exr 图像以 2^EV 倍亮度显示',
  'Metrics:': '度量：',
  'perceived difference when alternating between the pictures (FLIP), 0 … 1; for .exr over all relevant exposures':
    '交替观看两幅图像时可察觉的差异（FLIP），0 … 1；对 .exr 涵盖所有相关的曝光',
  'absolute differences of sRGB values 0 … 1, for .exr of linear light':
    'sRGB 值（0 … 1）的绝对差，对 .exr 为线性光的绝对差',
  "differences of .exr channels, and the displacement of A's points in B in pixels":
    '.exr 各通道的差异，以及 A 中的点在 B 中的位移（以像素计）',
  '{} of the pixels are different, and --fail-above allows {}': '{1} 的像素不同，而 --fail-above 允许 {2}',
  '--triptych needs a picture to draw: give -o FILE.png': '--triptych 需要输出图像：请给出 -o FILE.png',
  '--channel goes with --metric aov': '--channel 须与 --metric aov 同用',
  '--output {}: its name must end in .png': '--output {1}：文件名必须以 .png 结尾',
  'displacement needs the channels {} in both: render with --aov position,object, or name another by --channel':
    '计算位移时两幅图像都须有通道 {1}：请用 --aov position,object 渲染，或用 --channel 指定其他通道',
  '{}: only .exr pictures have channels to compare by --metric aov':
    '{1}：只有 .exr 图像才有可用 --metric aov 比较的通道',
  '{} and {} have no channel in common: {}, and {}': '{1} 与 {2} 没有共同的通道：前者有 {3}，后者有 {4}',
  '{} has no channel {}; it has {}': '{1} 没有通道 {2}；现有 {3}',
  '{} has {} × {}': '{1} 为 {2} × {3}',
  '{} pixels, {}: only pictures of one size can be compared; render both alike':
    '{1} 像素，{2}：只能比较大小相同的图像；请以相同大小渲染',
  '{} holds linear light and {} what a screen shows: give two .exr, or two .png or .jpg':
    '{1} 保存的是线性光，而 {2} 是屏幕所显示的：请给出两个 .exr，或两个 .png 或 .jpg',
  '{}: there is no such file': '{1}：没有这个文件',
  '{} is a folder; name a picture': '{1} 是文件夹；请指定图像',
  '{} has no channel {}; render it with --aov beauty,…': '{1} 没有通道 {2}；请用 --aov beauty,… 渲染',
  '{}: {} of pixel {} is {}, not a number to compare': '{1}：像素 {3} 的 {2} 为 {4}，不是可比较的数',
  '{}: {} against {}, {} × {} pixels': '{1}：{2} 对比 {3}，{4} × {5} 像素',
  mean: '平均',
  '99 of 100 pixels are at most': '99% 的像素不超过',
  largest: '最大',
  'above {}': '超过 {1}',
  '{} of the pixels': '{1} 的像素',
  'Difference of pixels': '像素的差异',
  'Difference of channels': '通道的差异',
  exposures: '曝光',
  '{}, {} … {} EV': '{1} 种，{2} … {3} EV',
  'root of the mean square': '均方根',
  'peak signal to noise': '峰值信噪比',
  'nothing differs': '没有差异',
  channel: '通道',
  'relative: mean': '相对：平均',
  pixels: '像素数',
  'another object': '不是同一物体',
  '{} pixels, {}': '{1} 个像素，{2}',
  '{} above {}': '{1} 超过 {2}',
  'only in A': '仅 A 有',
  'only in B': '仅 B 有',
  '{} not finite': '{1} 个不是有限数',
  displacement: '位移',
  'mean {} px, 99 % at most {} px, largest {} px': '平均 {1} px，99% 不超过 {2} px，最大 {3} px',
  'beyond {} px': '超过 {1} px',
  '{} of {} pixels; of these without a counterpart within a pixel: {}':
    '{2} 个像素中的 {1}；其中在一个像素之内没有对应点的：{3}',
  // convert, graph and serve
  'Converts a scene to another format, and reports what that cannot represent.':
    '将场景转换为其他格式，并报告该格式无法表示的内容。',
  'output file: {}': '输出文件：{1}',
  'print a report of what was written and what was lost as JSON': '以 JSON 格式输出报告：写出了什么，丢失了什么',
  '{}: a scene is written as {}, not as .{}': '{1}：场景可写为 {2}，不能写为 .{3}',
  '{} would be written over itself; name another file': '{1} 会覆盖自身；请指定其他文件',
  'Checks and upgrades projects, and prints the reference of all nodes.':
    '检查并升级项目，以及输出所有节点的参考说明。',
  'Reports errors in projects, node by node, without opening the files that they use.':
    '逐个节点报告项目中的错误，不打开其所用的文件。',
  'print the errors as JSON; for several projects, a list': '以 JSON 格式输出错误；有多个项目时为列表',
  'Upgrades a project to the current version; the same project always gives the same text.':
    '将项目升级到当前版本；相同的项目总是得到相同的文本。',
  'output file (default: the project itself)': '输出文件（默认：项目本身）',
  'Prints the reference of all nodes, in Markdown: sockets, parameters, units, ranges, defaults.':
    '以 Markdown 输出所有节点的参考说明：接口、参数、单位、范围、默认值。',
  'a single node type, such as relativity-console': '单个节点类型，例如 relativity-console',
  '{}: {} nodes, nothing is wrong': '{1}：{2} 个节点，没有错误',
  'there is no node type {}; there are {}': '没有节点类型 {1}；现有 {2}',
  'Serves the web page on this machine.': '在本机提供网页。',
  'port on 127.0.0.1; 0: any free port (default: {}, or any if that is in use)':
    '127.0.0.1 上的端口；0：任意空闲端口（默认：{1}，若被占用则任选一个）',
  'print the address as JSON': '以 JSON 格式输出地址',
  '\n  Slowlight is at  {}\n\n  Open it in a browser, pick a scene, then:\n    W A S D Q E   accelerate          mouse drag  look around\n    Shift         up to full speed    Tab         lock: free, look, fly\n    Space         play, pause         ?           all keys\n\n  Ctrl-C here stops it.':
    '\n  Slowlight 地址：{1}\n\n  请在浏览器中打开，选择场景，然后：\n    W A S D Q E   加速                拖动鼠标    环顾\n    Shift         直至最高速度        Tab         锁定：自由、环顾、飞行\n    空格          播放、暂停          ?           查看全部按键\n\n  在此按 Ctrl-C 停止。',
  'the page is not built. Run `npm run build` in the project folder (or `npm start`, which does it all)':
    '网页尚未构建。请在项目文件夹中运行 `npm run build`（或 `npm start`，它会完成一切）',
  'port {} is in use; choose another with --port, or stop what uses it':
    '端口 {1} 已被占用；请用 --port 另选一个，或停止占用它的程序',
  // simulate
  'Runs a simulation of a project, and writes the resulting motion and energies.':
    '运行项目中的模拟，并写出所得的运动与能量。',
  'output scene: .usda, .usdz, .usdc, .glb …': '输出场景：.usda、.usdz、.usdc、.glb …',
  'table of energies, momenta and speeds per frame': '各帧能量、动量与速度的表格',
  'id of the Simulate node, if the project has several': '模拟节点的 ID，用于项目有多个模拟节点时',
  'file that every frame is appended to as soon as it is computed': '检查点文件，每帧一算出即追加写入',
  'continue from the --checkpoint; the duration may differ': '从 --checkpoint 继续；时长可以不同',
  'print the result as JSON': '以 JSON 格式输出结果',
  '{} cannot be written ({}); name another file': '{1} 无法写入（{2}）；请指定其他文件',
  '{} is no checkpoint of a simulation; leave --resume out to begin anew':
    '{1} 不是模拟的检查点；请去掉 --resume 以重新开始',
  '{} was made of another simulation: its things, numbers, method or pace were others; set them as they were, or leave --resume out to begin anew':
    '{1} 属于另一个模拟：其物体、数值、方法或步长不同；请恢复原来的设定，或去掉 --resume 以重新开始',
  '{} cannot be read ({}); leave --resume out to begin anew': '{1} 无法读取（{2}）；请去掉 --resume 以重新开始',
  '{} is no project; what is simulated is said by its nodes': '{1} 不是项目；要模拟的内容由其节点指定',
  'name what to write: a scene with -o, a table of energies with --csv':
    '请指定要写什么：用 -o 写场景，用 --csv 写能量表格',
  '--resume goes on from a --checkpoint; name it too': '--resume 从 --checkpoint 继续；请一并指定',
  '{}: a scene is written as {}': '{1}：场景可写为 {2}',
  '--node {}: there is no such Simulate node; there is {}': '--node {1}：没有此模拟节点；现有 {2}',
  '{}: it has no Simulate node; add one': '{1}：没有模拟节点；请添加一个',
  '{} has several Simulate nodes; name one with --node: {}': '{1} 有多个模拟节点；请用 --node 指定其中一个：{2}',
  '{}: it cannot be simulated': '{1}：无法模拟',
  'stopped after {} of {} frames': '已停止，完成了 {2} 帧中的 {1} 帧',
  '--resume goes on from {}': '可用 --resume 从 {1} 继续',
  'nothing is written': '没有写出文件',
  // The reference of nodes
  '# Nodes': '# 节点',
  'What projects are made of; `slowlight graph docs` prints this page, and `slowlight graph docs TYPE` one node of it.':
    '项目由节点组成；`slowlight graph docs` 输出本页，`slowlight graph docs TYPE` 输出其中一个节点。',
  'Every parameter but a list is an input too: what is connected to it comes before what is set.':
    '除列表外，每个参数也都是输入：与之连接的值优先于所设的值。',
  'any number': '任意个',
  optional: '可选',
  '| parameter | | values | default |': '| 参数 | | 取值 | 默认 |',
  'three numbers [{}]': '三个数 [{1}]',
  'three numbers': '三个数',
  'linear sRGB': '线性 sRGB',
  texts: '若干文本',
  'on, off': '开、关',
  text: '文本',
  '{}, whole': '{1}，整数',
  'what the scene suggests, else {}': '场景建议的值，否则为 {1}',
  'by {}': '取决于 {1}',
  'an example': '示例',

  // ———— Flights ————
  'file of a flight, {}': '飞行文件，{1}',
  'file to write, {}': '要写的文件，{1}',
  "film a recorded flight, NAME.flight.json: frame n is at n/fps of the pilot's time from its beginning, or of world time (--spacing), --time likewise (default: all of it)":
    '拍摄录下的飞行 NAME.flight.json：第 n 帧位于从起点算起的驾驶者时间（或世界时间，见 --spacing）n/fps，--time 亦然（默认：全部）',
  "world time stands still or goes back in the flight, so that frames cannot follow it; let them follow the pilot's time":
    '飞行中世界时间停住或倒退，帧无法跟随它；请让帧跟随驾驶者时间',
  'even in your time': '按您的时间均匀',
  'even in world time': '按世界时间均匀',
  'Frames of the film follow': '影片各帧的间隔',
  "with --frames: whether n/fps is world time or proper time, of the observer's own clock; the clock on a moving camera shows 0 at world time 0, that of one who coasts starts with the first frame, and both begin with a flight (default: world, of a flight proper)":
    '与 --frames 合用：n/fps 是世界时间还是固有时（观察者自己的时钟）；运动相机上的时钟在世界时间 0 时显示 0，滑行者的时钟从第一帧开始，而飞行的两个时钟都从其起点开始（默认：world，飞行为 proper）',
  '--to is where the trip begins: there is nothing to fly': '--to 就是旅程的起点：无处可飞',
  '--from {}, --to {}: nothing lies between; {} lasts from 0 to {} s':
    '--from {1}、--to {2}：其间什么也没有；{3} 从 0 持续到 {4} 秒',
  "{} of the pilot's time, legs: {}": '驾驶者时间 {1}，航段数：{2}',
  '  {}: own clock {}, world {}, greatest γ {}, from {} to {} m, c = {} m/s{}{}':
    '  {1}：自己的时钟 {2}，世界 {3}，最大 γ {4}，从 {5} 到 {6} 米，c = {7} m/s{8}{9}',
  ', lock {}': '，锁定 {1}',
  ', world time paused': '，世界时间暂停',
  '{} s ({} years)': '{1} 秒（{2} 年）',
  'Plans trips, and inspects, cuts and joins recorded flights.': '规划旅程，并检查、剪切和连接录下的飞行。',
  'Plans the fastest trip to a place at rest with a constant proper acceleration: half the way forwards, half the way back.':
    '以恒定的固有加速度规划到一个静止地点的最快旅程：前一半加速，后一半减速。',
  'where it ends, world frame [m]': '终点，世界参考系 [m]',
  'where it begins, at rest, world frame [m]': '起点（静止），世界参考系 [m]',
  'proper acceleration': '固有加速度',
  'speed of light': '光速',
  'world time of the beginning': '起点的世界时间',
  'coast at this part of c (default: none)': '达到 c 的这一比例后滑行（默认：不限）',
  'and back again': '再返回',
  'Says how long a flight lasts on both clocks, how fast it is, and of what legs it is made.':
    '说明一次飞行在两个时钟上各持续多久、有多快、由哪些航段组成。',
  "Writes the part of a flight between two of the pilot's times.": '写出飞行在驾驶者两个时刻之间的部分。',
  "pilot's time from the beginning (default: the beginning)": '从起点算起的驾驶者时间（默认：起点）',
  "pilot's time from the beginning (default: the end)": '从起点算起的驾驶者时间（默认：终点）',
  'Writes flights one after the other as one.': '把几次飞行前后相接写成一次。',
  '--{} says where the observer is, and so does --flight: leave one of them out':
    '--{1} 说明观察者在哪里，--flight 也说明：请去掉其中之一',
  '--c {}: {} was flown at {} m/s; leave --c out, or fly it again':
    '--c {1}：{2} 是在 {3} m/s 下飞的；请去掉 --c，或重新飞一次',
  '{}: the flight lasts from 0 to {} s': '{1}：飞行从 0 持续到 {2} 秒',
  '--flight films with -o; nodes of a project film on their own': '--flight 与 -o 一起使用；项目的节点自行拍摄',
  'By hand': '由手控制',
  'Into the motion': '朝运动方向',
  'Against the motion': '背对运动方向',
  'Where the engine pushes': '朝发动机推动的方向',
  'Way of flying': '飞行方式',
  'Thrust along the nose': '沿船头的推力',
  'Thrust across': '横向推力',
  'The nose points': '船头指向',
  'Keep the horizon level': '保持地平线水平',
  'In fast motion': '快速运动时',
  'No vignette': '不加暗角',
  'Mild vignette': '轻微暗角',
  'Strong vignette': '强暗角',
  Turning: '转向',
  Continuously: '连续转动',
  'In steps of {}°': '每步 {1}°',
  'Fly through walls': '穿墙飞行',
  'Stop before walls': '在墙前停下',
  'Slide along walls': '沿墙滑行',
  'Preparing walls and ground…': '正在准备墙面和地面……',
  'Follow the ground': '沿地面行驶',
  'Come down to the ground': '降到地面',
  'There is no ground below.': '下方没有地面。',
  'Height of the eye above it [m]': '眼睛离地高度 [m]',
  'Braking for a wall': '正在为墙制动',
  'Too fast: cannot stop before the wall': '太快：无法在墙前停下',
  'At a wall': '已到墙边',
  Collisions: '碰撞',
  'Distance from walls [m]': '与墙的距离 [m]',
  'What deforms is no wall.': '会变形的物体不算墙。',
  'Nothing in this scene moves as a whole.': '这个场景中没有整体运动的物体。',
  'What you follow': '跟随的物体',
  'Fly to an object': '飞到一个物体',
  Recording: '录制',
  Record: '录制',
  'Open a flight': '打开飞行',
  Replay: '重放',
  'Fly on from here': '从这里继续飞',
  'Time of the flight': '飞行的时间',
  'Cut off before': '剪掉之前',
  'Cut off after': '剪掉之后',
  'Save the flight': '保存飞行',
  'Save a film': '保存影片',
  'The recording is full, and has ended. Save it, and start another.': '录制已满，已经结束。请保存它，再开始一次。',
  'there is no picture to film': '没有可拍摄的画面',
  'Twist two fingers': '两指扭转',
  'Roll, as the way of flying allows': '滚转（视飞行方式而定）',
  'Next way of flying: velocity, drive, thrust …': '下一种飞行方式：速度、行驶、推力……',
  Brake: '制动',
  'Roll left, right': '向左、右滚转',
  'Record the flight, or stop': '录制飞行，或停止',
  'Gamepad: left stick flies, right stick looks, bumpers go down and up, triggers brake and allow full speed, left and right roll, A plays, Y changes the lock.':
    '手柄：左摇杆飞行，右摇杆环视，肩键下降和上升，扳机制动和全速，左右方向键滚转，A 播放，Y 切换锁定。',
  Autopilot: '自动驾驶',
  'Flies to the place that you choose and stops there: half the way it accelerates, half the way it brakes.':
    '飞到你选的地点并停在那里：前一半路加速，后一半路制动。',
  Drive: '行驶',
  'As Velocity, along the ground wherever you look, or at one height where there is none.':
    '与“速度”相同，但无论看向哪里都沿地面前进；没有地面时高度不变。',
  Follow: '跟随',
  'Takes the velocity of what you follow, and stays in its rest frame. The keys move you there.':
    '取所跟随物体的速度，留在它的静止系中。按键使你在其中移动。',
  Thrust: '推力',
  "The keys are engines: a constant proper acceleration along the ship's own axes. Let go, and you coast.":
    '按键是发动机：沿飞船自己的轴的恒定固有加速度。松开后滑行。',
  Vehicle: '飞行器',
  'As Thrust, and the nose turns into the motion.': '与“推力”相同，并且船头转向运动方向。',
  'The keys ask for a velocity. Let go to brake.': '按键要求一个速度。松开即制动。',
  'the file: more than the {} MiB of a flight': '文件：超过飞行文件的 {1} MiB 上限',
  '{}: it pushes beyond rapidity {}, or lasts for ever; let it be shorter': '{1}：推动超过快度 {2}，或永不结束；请缩短',
  '{}: its length is {}; it must be 1': '{1}：长度是 {2}，必须是 1',
  'leg {} flies at c = {} m/s, those before at {} m/s; a film has one speed of light: cut the flight there':
    '航段 {1} 在 c = {2} m/s 下飞行，之前的在 {3} m/s；一部影片只有一个光速：请在那里剪开',
  'the flight was flown at {} m/s, and light has {} m/s now; set it back to that for the film':
    '这次飞行是在 {1} m/s 下飞的，而现在光速是 {2} m/s；拍影片前请改回去',
};

const examples: Translation['examples'] = {
  street: {
    title: '街道',
    lookFor:
      '以 0.9 c 沿街飞行。一切都向你前进的方向聚拢：已经经过的房屋正面又出现在眼前。门、路灯和柱子弯曲了，而沿着前进方向的路缘与屋檐仍然笔直。前方变蓝变亮，后方变红变暗。',
  },
  dice: {
    title: '骰子',
    lookFor:
      '象牙色骰子以 0.8 c 迎面而来，你却能看到它们背后的“六”点：它们看上去不是被压扁，而是转了过去（特勒尔旋转，在与你并排处角度为 arcsin 0.8 = 53°）。蓝色骰子速度为 0.5 c，红色骰子静止。在“同时面”视图中，象牙色骰子的长度是原来的 0.6 倍。',
  },
  wheel: {
    title: '轮子',
    lookFor:
      '轮子以 0.6 c 滚动；轮顶速度为 0.88 c，触地点静止。在路面的“同时面”视图中它是椭圆，辐条是弯的：轮毂参考系中各处的“此刻”，在这里并不同时。支架上的轮子只转不走。',
  },
  sphere: {
    title: '球',
    lookFor:
      '三个球分别以 0.5、0.8 和 0.95 c 穿过圆环。在“同时面”视图中它们是扁的；但你所看到的轮廓始终是正圆，只有经线透露真相：你看到了背面。飞过静止的球，也是如此。',
  },
  lattice: {
    title: '晶格',
    lookFor:
      '沿运动方向的杆保持笔直；与之垂直的红色和米色杆弯成双曲线，节点仍是圆的。在 0.9 c 时，连已在身后的杆也会出现在前方。',
  },
  hall: {
    title: '大厅',
    lookFor:
      '每块瓷砖边长两米。静止时线条笔直；给自己一个速度（按 Tab，再按 W），墙壁向外弓起，远处的墙退去，肩后的瓷砖进入视野。',
  },
  lamps: {
    title: '光谱灯',
    lookFor:
      '只发谱线的灯——钠、汞、氢——以 0.32 c 在灰墙前来回穿梭。每盏灯都用自己移了频的光给墙着色：钠的黄光在前方是蓝的，然后是绿的，正对着是黄的，身后是红的，再往后便什么也没有，因为它唯一的谱线已移出视觉范围。在两端它们静止片刻，露出真正的颜色。',
  },
  prism: {
    title: '棱镜',
    lookFor:
      '三张相同的色卡，各带一盏灯：左边的以 0.34 c 迎面而来，右边的离去，中间的静止；然后左右互换。迎面而来的更蓝更亮：红色和橙色格变成蓝色。离去的更红更暗：蓝色格变红，红色格变成暗青色。下方是树叶、皮肤、沥青、雪、金和铜：迎面而来的绿叶是红的，因为它明亮的红外光进入了视野。',
  },
  sunset: {
    title: '日落街道',
    lookFor:
      '最后的夕阳，窗后的煤气灯。以 0.8 c 飞行：正前方看到的全是红外光。刚才还比墙暗的树变得与墙一样亮，沥青仍然暗；黄色的窗变白了，因为 2200 K 的光此时看上去像 6600 K。被夕阳照到的墙也变白，只有天空照到的地方是蓝的。',
  },
  starfield: {
    title: '星空',
    lookFor:
      '真实的星空，猎户座在正前方。加速时群星向前方聚拢：在 0.9 c 时，原来前半个天空收进 26° 的圆内，猎户的腰带缩到不足四分之一。发红的参宿四变成蓝白色；回头看，天空空旷而暗红。',
  },
  saturn: {
    title: '土星',
    lookFor:
      '一个房屋大小的模型，置于光如步行的世界。以将近 0.9 c 经过时，球体的圆形轮廓几乎不变，而光环看上去歪斜了，远侧跑到了近侧的前面，群星聚拢到你的前方。',
  },
  gallery: {
    title: '画廊',
    lookFor:
      '处处是直角，因此弯曲一目了然：画框倾斜，拱顶张开，已经经过的画又转过脸来。它们的颜色说明你以多快的速度迎向它们的光。',
  },
  plain: {
    of: 'Plain',
    title: '寻常画面',
    lookFor:
      '与其他程序所画的晶格一样：穿行其中，什么都不弯曲。然后逐项恢复，看每一项的作用：把“视图”设为“所见”，杆就弯了；“多普勒混合”设为 1，就有了颜色；“聚束”设为 1，前方变亮，后方变暗。',
  },
  cubes: {
    title: '立方体与球',
    lookFor:
      '地面由边长 5 m 的方格铺成，立方体最快达 0.9 c，球的赤道以 0.62 c 转动。迎面而来的立方体被拉长、发蓝，远去的缩短、发红、变暗，从旁经过的露出背面。球上迎来一侧的方格宽，远去一侧的窄。飞行时整个地面弯曲，而参考网格（G）保持笔直。',
  },
  arcade: {
    title: '拱廊',
    lookFor:
      '三十万个三角形：120 根柱子、拱顶与栏杆，阳光照进庭院，院中有一个青铜球。以 0.9 c 行进时，拱券向内倾斜，回廊环抱而来，前方发蓝。',
  },
  boxes: {
    title: '盒子',
    lookFor:
      '只有直棱平面的盒子，所以一切弯曲都来自光。从 0.9 c 起，背向你的面进入视野，前方的行列收成一个明亮的小圆盘。',
  },
  drops: {
    title: '液滴',
    lookFor:
      '流体模拟所写的样子：每个采样是另一个网格，带有速度。两滴液体以 0.55 c 经过，时而合并，时而分开。看到的是光离开时它们的位置与形状，远端早于近端，所以一幅画面里有几个网格的部分；迎面而来时长而蓝，离去时短而红。',
  },
  ...Object.fromEntries(
    [0.892, 0.949, 0.968].map((beta) => [
      `boxes-${1000 * beta}`,
      {
        of: `Boxes at ${beta} c`,
        title: `盒子，${beta} c`,
        lookFor:
          '加速过程的三个时刻之一：在同一地点分别为 0.892、0.949 与 0.968 c。前方逐次缩小，后方更多的景物进入视野。“多普勒混合”与“聚束”为 0；设为 1 可看到其光色。',
      },
    ]),
  ),
  rush: {
    of: 'Relativistic street',
    title: '相对论街道',
    lookFor:
      '从第一幅画面起就以 0.9 c 行驶，而你停在原处（“观察”），可以慢慢看：身后的房屋倾斜着进入视野，中央发蓝而遥远，边缘发红而昏暗。按 Tab 切换到“自由”即可前行。',
  },
  workshop: {
    of: 'Workshop',
    title: '工场',
    lookFor:
      '全部由节点构成，这里光速只有 12 m/s。框架以 7 m/s 驶过，球以 8 m/s 绕圈，圆环自转，飞镖从静止加速，木箱沿弯路前行，砖块翻滚着从一处到另一处。每样东西都显示在光离开它时所在的位置；驶来的偏蓝，离去的偏红。',
  },
  layers: {
    of: 'Layers',
    title: '分层',
    lookFor:
      '画面由各层组成：不含环境光遮蔽的光照，乘以每处所见天空的比例（平滑但不越过边缘）；再加上对焦于前方几米处的镜头和亮处的光晕。停用一个节点，看看它的作用。',
  },
  comparison: {
    of: 'Seen and there',
    title: '所见与实在',
    lookFor:
      '左边是以 0.4 c 行进时的所见，右边是普通渲染器所绘的同一时刻。移动分界线（不透明度）：灯柱会跳开，越往前越远，并失去蓝色；移动的箱子先在它曾在的位置，再到它现在的位置。将模式设为正常，两者便互相透出。',
  },
  lesson: {
    of: 'Colours and bands',
    title: '颜色与波段',
    lookFor:
      '同一条街两次：右边是 0.4 c 时的所见，左边按光离开时所属的光谱部分着色。正前方看到的光离开时是红外光；越往两侧频移越小，在你前方逃离的物体保持原色。在“伪彩色”中可改选多普勒因子或光离开的时刻。',
  },
  'gods-eye': {
    of: "God's eye",
    title: '上帝视角',
    lookFor:
      '从上方看世界的一个瞬间；角上的小窗是观察者（蓝色圆点）在同一瞬间所见。红色列车以 0.8 c 从他身旁驶过，长度是静止的黄色列车（构造相同）的 0.6 倍。此刻越过第三环的东西，他要 3 秒后才看到。比较红色列车实际所在与他所见的位置。飞行时，圆点就是你，箭头是你一秒内前进的距离；若达到 c，它会触到第一环。',
  },
  letters: {
    of: 'Letters',
    title: '立体文字',
    lookFor:
      '立体字母组成的词，这里光速是 10 m/s。白色的静止；上方黄色的以 0.8 c 飞过，向你露出它们的侧端，并显出并非自身的颜色。',
  },
  truth: {
    of: 'Two renderers',
    title: '两种渲染器',
    lookFor:
      '以 0.1 c 进入一个房间，画了两次。左边是精确渲染器的静帧，它追踪光在物体之间的往返，因此墙面给白色物体染色，黄铜球带上房间的颜色。右边是飞行时使用的渲染器。边线从一边接续到另一边。把混合模式设为差值：剩下的就是那部分光，以及噪点，采样越多噪点越少。转动或飞行时，静帧保持不变。',
  },
  ladder: {
    title: '梯子与谷仓',
    lookFor:
      '16 米长的梯子以 0.6 c 穿过 14 米长的谷仓。在谷仓的参考系中它长 12.8 米，两扇门有一刻同时关闭，把它全部关在里面。在梯子的参考系中（用“同时面”视图跟随相机 /World/Rider），谷仓长 11.2 米，两扇门从不同时关闭。',
  },
  twins: {
    title: '双生子',
    lookFor:
      '金色的表盘以 0.6 c 飞到六光秒外的圆环再返回；红色标记处是它的时间。它回来时显示 16 s，留在家里的表盘显示 20 s。从家里看，它先慢走 16 s，再快走 4 s：转弯处的光要先回来。“时钟”面板列出所见的读数和同时的读数。',
  },
  'texture-cube': {
    of: 'Textures at speed: a cube',
    title: '高速下的纹理：立方体',
    lookFor:
      '0.6 c 下一个棋盘格立方体的内部，由六个面的图片给出。左边是纹理映射论文（Mantiuk 等，2004）的画法：方向正确，颜色按它的简单光谱移动，亮度不变。右边是实际所见：前方比旁边亮得多。用 W 和 S 改变速度：前方的方格缩小，身后的东西进入视野。',
  },
  'texture-hall': {
    of: 'Textures at speed: a hall',
    title: '高速下的纹理：大厅',
    lookFor:
      '0.6 c 下的大厅，取自静止时一次绘制的六个面：这就是纹理映射论文（Mantiuk 等，2004）的流程，只是每个表面的光重新计算，而不是存下颜色。左边是论文的颜色和亮度，右边是实际所见。用 W 和 S 改变速度，并环顾四周：只要停留原地，就不绘制任何几何体。去掉“捕获”节点，比较一下。',
  },
  'texture-interior': {
    of: 'Textures at speed: an interior',
    title: '高速下的纹理：室内',
    lookFor:
      '与立方体相同，但用的是高动态范围的全景图，就像相机拍下的那样：由参考渲染器在静止时追踪的大厅。每个纹素只知道颜色，右边把它当作日光下表面的颜色。与捕获的大厅比较：那里光源和材质都是已知的。用 W 和 S 改变速度，并向身后看。',
  },
  'clocks-around': {
    of: 'Clocks in a film',
    title: '影片中的时钟',
    lookFor:
      '一部无穷远处的 360° 影片，四周都是时钟，指针八秒走一圈，速度为 0.6 c。起初你停留原地，所有时钟一致：按 Tab 开始飞行。按你自己的钟，前方的走得快一倍，身后的慢一半，与颜色的移动是同一个因子；你飞离的镜球里也能看到它们。停下（X）：它们又走得一样快，但不再一致，因为你离前方时钟的光更近。',
  },
  captured: {
    of: 'Captured hall',
    title: '捕获的大厅',
    lookFor:
      '0.9 c 下的大厅，取自静止时一次绘制的六个面。环顾四周，并在停留原地时改变速度（W 和 S）：你周围的一切不变，变的只是方向和光，不再绘制任何几何体。向后看：那里各面的纹素被拉开。去掉“捕获”节点，比较一下。',
  },
  checkerboards: {
    of: 'Checkerboards',
    title: '棋盘格',
    lookFor:
      'Slowlight 所遵循的程序（朱雨田、刘子潮、夏子汐，2024，图 14）的完整节点图及其测试场景：方块掠过、球在棋盘格地板上方旋转，光速为 10 m/s。环境光遮蔽经过平滑，由用 GLSL 编写的效果与画面相乘；远处的物体淡入天空；再混入十分之一普通渲染器的画面，显示一切当时在哪里。',
  },
  'hanging-cloth': {
    of: 'Hanging cloth',
    title: '悬挂的布',
    lookFor:
      '一块由 625 个质点和弹簧组成的布，两角固定，水平放开，此处光速为 10 m/s。下摆像鞭子一样甩动时，有一点达到 0.86 c；但没有一点能达到 c，因为力改变的是动量。靠近时明亮，远离时暗淡，你看到的每一处都是它过去的样子。切换到“同时面”视图，看看它现在在哪里。',
  },
  'source-speeds': {
    of: 'The sources’ methods at c = 1, 10, 100',
    title: '原报告的方法，c = 1、10、100',
    lookFor:
      '同一块布，所处世界的速度分别不超过 1、10 和 100 m/s；前三列用原报告的方法和它推荐的割线修正，蓝色一列用我们的方法，能量守恒。1 m/s 时布落得很慢。半隐式的布爆裂，并停在计算终止时的样子：其节点呈琥珀色，说明何时、为何终止。每个“模拟”节点都有自己的方法、修正、步长和光速：改改看。',
  },
  'source-corrections': {
    of: 'The sources’ methods and corrections',
    title: '原报告的方法与修正',
    lookFor:
      '本程序所依据的报告中的布，用它的各种方法计算，c = 10 m/s，步长 1 ms。各行：不修正、切线、割线、求根。半隐式的布颤抖并爆裂；隐式的布像在蜂蜜里一样渐渐停下，割线对此不起作用；求根使能量守恒。蓝色是我们的方法，步长减半。琥珀色的节点说明出了什么问题，能量面板把它画出来。',
  },
  'source-ball': {
    of: 'The sources’ cloth and ball at c = 1, 10, 100',
    title: '原报告的布与球，c = 1、10、100',
    lookFor:
      '报告中的布荡向半径 40 cm 的球，球以 10⁴ N/m 推开它，所处世界的速度分别不超过 1、10 和 100 m/s，步长 1 ms：前三列为原方法加割线修正，蓝色为我们的方法。隐式的布每一步都损失能量，正如报告中的动画；半隐式的布撞到球便爆裂，并停在那时的样子。“保存视频”，或只给项目名的 “slowlight render”，会把它存成 GIF。',
  },
  'falling-cloth': {
    of: 'Cloth on a ball',
    title: '落在球上的布',
    lookFor:
      '一块布落在固定的球上，光速为 10 m/s。中间被挡住，四角继续下落，荡到球下方。球和地面把侵入的部分推出，陷得越深推得越狠，所以猛烈撞击会陷进一些。只有空气带走能量：打开能量面板看看它去了哪里。',
  },
  impact: {
    of: 'Elastic ball against rigid ball',
    title: '弹性球撞刚性球',
    lookFor:
      '弹簧组成的球以 0.6 c 撞上一个质量相同、可自由运动的刚性球。动量分毫不差地传递，弹簧却留下一部分能量：红球从此颤动不止，蓝球以 0.57 c 离开。若是两个刚性球，能量会全部传递。',
  },
  bouncing: {
    of: 'Bouncing lattice',
    title: '弹跳的晶格',
    lookFor:
      '弹性杆组成的晶格一角着地后弹起，光速为 10 m/s。撞击以波的形式穿过晶格；上方要晚些才得知，那时还在下落。快速横过视线的直杆看上去是弯的，因为远端的光出发得更早。',
  },
  pendulums: {
    of: 'Pendulums at c = 1, 10 and 100',
    title: 'c = 1、10 和 100 的单摆',
    lookFor:
      '三个一米长的单摆从水平位置放开，所处世界的光速分别为 1、10 和 100 m/s。10 和 100 的摆动几乎与牛顿力学相同，周期 2.4 s。1 m/s 的那个几乎全程都以接近 1 m/s 运动，来回要 6.7 s。你用 10 m/s 的光看它们。',
  },
  cradle: {
    of: "Relativistic Newton's cradle",
    title: '相对论牛顿摆',
    lookFor:
      '五个球挂在 3 m 长的杆上，光速为 10 m/s。第一个球落下，以 0.47 c 撞上其余的球；最后一个带走它全部的动量荡出去，其余几乎不动。质量相等的物体接近光速时也像低速时一样交换速度：动量和能量不容许别的结果。迎面而来的球比远去的更亮。',
  },
  charges: {
    of: 'Two charges',
    title: '两个电荷',
    lookFor:
      '质量相同的一正一负两个电荷互相绕行，最快 0.6 c。按牛顿力学它们永远沿同一个椭圆运动；这里动量比速度增长得更快，使椭圆每圈转过 45°，画出玫瑰花形。桌上的金线是索末菲用公式求出的轨迹，两球始终沿着它走；相距最远时两者都碰到蓝色圆环。你看到的都是各自过去的位置，所以它们看上去并不正对。力是瞬时作用的，没有真实电荷会损失的辐射。',
  },
};

export const chinese: Translation = { messages, examples };
