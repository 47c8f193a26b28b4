import type { MessageCatalogue } from './translateMessage.ts';

/** Messages of all other files: OBJ, PLY, STL, zip, pictures, tables, fonts; see index.ts for the format. */
export const files: MessageCatalogue = {
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
};
