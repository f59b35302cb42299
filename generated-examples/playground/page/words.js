// What the page says, in English and Chinese. What the compiler says comes from the compiler.

const WORDS = {
  title: ["dh: kinematics from a table", "dh：由 DH 表得到运动学"],
  example: ["Example", "示例"],
  robots: ["Robots", "机器人"],
  lectures: ["Tables of lectures, with their derivations", "讲义中的表格及推导"],
  own: ["your own table", "自己的表格"],
  "copy link": ["Copy link", "复制链接"],
  open: ["Open", "打开"],
  save: ["Save .dh", "保存 .dh"],
  language: ["Language", "语言"],
  theme: ["Colours", "颜色"],
  auto: ["as the system", "跟随系统"],
  light: ["light", "浅色"],
  dark: ["dark", "深色"],
  table: ["Table of the arm", "机械臂的参数表"],
  help: ["How a table is written", "表格的写法"],
  results: ["Results", "结果"],
  stop: ["Stop", "停止"],
  private: ["Everything is computed in this page. Nothing is sent anywhere.", "所有计算都在本页面内完成，不向任何地方发送数据。"],
  line: ["line {}", "第 {} 行"],
  whole: ["table", "全表"],
  fine: ["{name}: {rows} rows, {joints} joints", "{name}：{rows} 行，{joints} 个关节"],
  wrong: ["{n} mistakes", "{n} 处错误"],
  "wrong one": ["1 mistake", "1 处错误"],
  doubtful: ["no inverse as the table stands", "按此表无法求逆解"],
  stale: ["The table has mistakes; this belongs to the table before.", "表格有误；此处仍是之前表格的结果。"],
  nothing: ["The table has mistakes: see below the table.", "表格有误：见表格下方。"],
  working: ["Computing… {} s", "正在计算… {} 秒"],
  stopped: ["Stopped.", "已停止。"],
  timeout: ["This took too long and was stopped.", "耗时过长，已停止。"],
  broken: ["This was too large for the memory of the page and was stopped.", "超出页面可用的内存或栈，已停止。"],
  again: ["Try again", "重试"],
  copied: ["Copied", "已复制"],
  copy: ["Copy", "复制"],
  download: ["Download", "下载"],
  arm: ["Arm", "机械臂"],
  formulas: ["Formulas", "公式"],
  notes: ["Notes", "讲义"],
  plan: ["Plan", "求解方案"],
  code: ["Rust", "Rust"],
  derivation: ["Check", "检验推导"],
  page: ["Download this page", "下载此页面"],
  solutions: ["At most {} solutions for a pose.", "一个位姿最多有 {} 个解。"],
  "no plan": ["There is no inverse for this table:", "此表无法求逆解："],
  "in your crate": ["In your own crate", "在自己的程序中"],
  expansion: ["What the macro makes of it", "宏展开后的代码"],
  paste: [
    "Type or paste a derivation about this arm: LaTeX, Markdown or plain text. Every formula is proven or refuted in exact algebra.",
    "输入或粘贴关于此机械臂的推导：LaTeX、Markdown 或纯文本。每个公式都用精确代数证明或反驳。",
  ],
  "own formulas": ["Insert this arm's formulas", "插入此机械臂的公式"],
  clear: ["Clear", "清空"],
  proven: ["proven", "已证明"],
  where: ["proven under a condition", "有条件成立"],
  agrees: ["proven for the values given", "对给定数值成立"],
  "is wrong": ["wrong", "错误"],
  unclear: ["not understood", "未能理解"],
  definition: ["definition", "定义"],
  "in the table": ["Lines of the table's prove blocks", "表中 prove 块的各行"],
  "no lines": ["No formula about the arm was found in the text.", "文中没有找到关于此机械臂的公式。"],
  "not read": ["This file is too large to be a table.", "文件过大，不是表格。"],
};

const HELP = {
  en: `
    <p>A table begins with a name and a convention, names its lengths, and has a row for each joint:</p>
<pre>pub struct Arm;
convention = modified;         // or standard
let l1: length = 0.4m;         // a name with a nominal value
task = position;               // pose (default), position, planar, axis

| alpha | a  | d | theta | range           |
|-------|----|---|-------|-----------------|
| 0     | 0  | 0 | q1    | -170deg..=170deg |
| 0     | l1 | 0 | q2    |                 |</pre>
    <ul><li><code>standard</code>: row i holds theta, d, a, alpha of link i. <code>modified</code> (Craig): alpha and a of link i-1, d and theta of link i.</li>
    <li>Lengths: <code>0.4318m</code>, <code>431.8mm</code>, <code>cm</code>, <code>in</code>; a bare number is in metres (<code>unit = mm;</code> changes that).</li>
    <li>Angles: <code>90deg</code>, <code>pi/2</code>, <code>0.25turn</code>. Offsets as in the book: <code>q2 - 90deg</code>.</li>
    <li>The joint variable stands in <code>theta</code> where the joint turns, in <code>d</code> where it slides. A row without one is a fixed link.</li>
    <li><code>base = tz(373mm);</code> and <code>tool = tz(0.1m) * ry(90deg);</code> stand before and after the chain.</li>
    <li>Seven joints: <code>redundant = q3;</code> names the one that the caller chooses. <code>ik = none;</code> asks for no inverse.</li>
    <li><code>prove { T(1,3).px = a2*c2; }</code>: lines of a derivation that belong to the table.</li></ul>`,
  zh: `
    <p>表格以名称和约定开头，声明各长度，每个关节一行：</p>
<pre>pub struct Arm;
convention = modified;         // 或 standard
let l1: length = 0.4m;         // 有标称值的名称
task = position;               // pose（默认）、position、planar、axis

| alpha | a  | d | theta | range           |
|-------|----|---|-------|-----------------|
| 0     | 0  | 0 | q1    | -170deg..=170deg |
| 0     | l1 | 0 | q2    |                 |</pre>
    <ul><li><code>standard</code>：第 i 行为连杆 i 的 theta、d、a、alpha。<code>modified</code>（Craig）：连杆 i-1 的 alpha、a 和连杆 i 的 d、theta。</li>
    <li>长度：<code>0.4318m</code>、<code>431.8mm</code>、<code>cm</code>、<code>in</code>；不带单位的数以米计（可用 <code>unit = mm;</code> 更改）。</li>
    <li>角度：<code>90deg</code>、<code>pi/2</code>、<code>0.25turn</code>。偏置照书写：<code>q2 - 90deg</code>。</li>
    <li>转动关节的变量写在 <code>theta</code> 列，移动关节的写在 <code>d</code> 列。没有变量的行是固定连杆。</li>
    <li><code>base = tz(373mm);</code> 和 <code>tool = tz(0.1m) * ry(90deg);</code> 位于链的前后。</li>
    <li>七个关节：<code>redundant = q3;</code> 指定由调用者给定的关节。<code>ik = none;</code> 表示不求逆解。</li>
    <li><code>prove { T(1,3).px = a2*c2; }</code>：属于此表的推导各行。</li></ul>`,
};

let language = "en";
const word = (key) => WORDS[key]?.[language === "zh" ? 1 : 0] ?? key;

// All that stands in the page's own markup: `data-word` is its text, `data-label` its name for screen readers.
function translate() {
  document.documentElement.lang = language;
  document.title = word("title");
  for (const node of document.querySelectorAll("[data-word]")) node.textContent = word(node.dataset.word);
  for (const node of document.querySelectorAll("[data-label]")) node.setAttribute("aria-label", word(node.dataset.label));
  byId("helptext").replaceChildren(elements(HELP[language]));
}
