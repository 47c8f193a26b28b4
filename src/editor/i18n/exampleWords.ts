/** The words of the example scenes in Chinese; in English they are the scenes' own, in their files. */
export const exampleWords: Readonly<Record<string, { readonly title: string; readonly lookFor: string }>> = {
  street: {
    title: '街道',
    lookFor:
      '以 0.9 c 沿街飞行。一切都向你前进的方向聚拢：已经经过的房屋正面又出现在眼前，笔直的屋檐弯曲了。前方变蓝变亮，后方变红变暗。',
  },
  dice: {
    title: '骰子',
    lookFor:
      '红色骰子以 0.8 c 经过。它们看上去不是被压扁，而是转了过去：你能看到背对你的“六”点那一面（特勒尔旋转，角度为 arcsin 0.8 = 53°）。在“同时面”视图中，它们的长度是原来的 0.6 倍。',
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
  saturn: {
    title: '土星',
    lookFor:
      '一个房屋大小的模型，置于光如步行的世界。以 0.9 c 经过时，无论多快，球的轮廓始终是圆，而扁平的环弯曲了，群星聚拢到你的前方。',
  },
  gallery: {
    title: '画廊',
    lookFor:
      '处处是直角，因此弯曲一目了然：画框倾斜，拱顶张开，已经经过的画又转过脸来。它们的颜色说明你以多快的速度迎向它们的光。',
  },
  ladder: {
    title: '梯子与谷仓',
    lookFor:
      '16 米长的梯子以 0.8 c 穿过 12 米长的谷仓。在谷仓的参考系中它长 9.6 米，两扇门可同时关上并把它全部关在里面。在梯子的参考系中（用“同时面”视图跟随相机 /World/Rider），谷仓长 7.2 米，两扇门从不同时关闭。',
  },
};
