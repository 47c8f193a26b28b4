/** Texts of opening, saving, sharing and restoring projects. Merged into the catalogue. */
export const projectTexts = {
  'project.menu': ['Project', '项目'],
  'project.new': ['New', '新建'],
  'project.save': ['Save project', '保存项目'],
  'project.saveAll': ['Save with its files', '连同文件一起保存'],
  'project.share': ['Share by a link…', '用链接分享…'],
  'project.rename': ['Name…', '命名…'],
  'project.name': ['Name of the project', '项目名称'],
  'project.unnamed': ['Unnamed', '未命名'],
  'project.unsaved': ['Not saved to a file', '尚未保存到文件'],
  'project.earlier': ['Earlier work', '之前的工作'],
  'gallery.projects': ['Projects', '项目'],
  'gallery.projectsIntro': [
    'Graphs of nodes: open one, change it, save it as your own.',
    '节点图：打开、修改，并保存为自己的项目。',
  ],
  'project.done': ['Done', '完成'],

  'edit.openProject': ['open a project', '打开项目'],
  'edit.rename': ['name the project', '命名项目'],

  'share.title': ['Share by a link', '用链接分享'],
  'share.intro': [
    'The whole project is in the link, after the #. Only people who get the link can see it.',
    '整个项目都在链接中 # 之后的部分。只有得到链接的人才能看到它。',
  ],
  'share.link': ['Link', '链接'],
  'share.copy': ['Copy', '复制'],
  'share.copied': ['Copied', '已复制'],
  'share.local': [
    'A link cannot contain files, and this project reads some from your device: {{files}}. Save it with its files and send the zip.',
    '链接无法携带文件，而此项目读取了您设备上的文件：{{files}}。请连同文件一起保存，然后发送该 zip。',
  ],

  'notice.savedWithout': [
    'Saved {{name}}. It reads files that it does not contain ({{files}}): keep them beside it, or save with its files.',
    '已保存 {{name}}。它读取的文件不在其中（{{files}}）：请把它们放在旁边，或连同文件一起保存。',
  ],
  'notice.packing': ['Collecting files…', '正在收集文件…'],
  'notice.tooMuchToPack': [
    'Its files are {{size}}, more than the {{most}} that the page can pack. Save the project alone, and keep the files beside it.',
    '它的文件共 {{size}}，超过页面可打包的 {{most}}。请只保存项目，并把文件放在旁边。',
  ],
  'notice.notKept': [
    'This browser cannot store your work ({{why}}): unsaved changes are lost when the page is closed. Save the project, or free some storage.',
    '浏览器无法保留您的工作（{{why}}）：关闭页面后，未保存的内容会丢失。请保存项目，或释放存储空间。',
  ],
  'notice.filesNotKept': [
    'The files ({{size}}) are too large to be stored in the browser. After a reload they must be opened again; everything else is kept.',
    '文件（{{size}}）太大，无法保留在浏览器中。重新加载页面后需再次打开它们；其余内容都会保留。',
  ],
  'notice.earlier': ['There is unsaved work from {{when}}: {{name}}.', '有 {{when}} 未保存的工作：{{name}}。'],
  'notice.continue': ['Restore', '继续'],
} as const satisfies Record<string, readonly [en: string, zh: string]>;
