//! All text of the notes, in every language. `{}` takes a formula or name.

use crate::render::Language;

macro_rules! phrases {
    ($($(#[$doc:meta])* $name:ident: $english:literal, $chinese:literal;)*) => {
        /// Everything that a note can say.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub(in crate::render) enum Phrase {
            $($(#[$doc])* $name,)*
        }

        impl Phrase {
            /// The words.
            pub(in crate::render) fn in_language(self, language: Language) -> &'static str {
                match (self, language) {
                    $((Phrase::$name, Language::English) => $english,
                      (Phrase::$name, Language::Chinese) => $chinese,)*
                }
            }
        }
    };
}

phrases! {
    Title: "Kinematics of {}", "{} 的运动学";
    Parameters: "Denavit-Hartenberg parameters", "DH 参数";
    Modified: "Modified convention (Craig): frame {} sits on the axis of joint {}; row {} lists the twist and the length of link {}, {} and {}.",
        "改进型约定（Craig）：坐标系 {} 位于关节 {} 的轴上；第 {} 行给出连杆 {} 的扭转角 {} 与长度 {}。";
    Standard: "Standard convention: frame {} sits at the far end of link {}, on the axis of joint {}.",
        "标准型约定：坐标系 {} 位于杆件 {} 的末端，即关节 {} 的轴上。";
    Lengths: "Lengths in {}: ", "长度（单位：{}）：";
    Angles: "Constant angles: ", "常量角：";
    Free: "Free parameters: ", "自由参数：";
    Fixed: "fixed", "固定";
    Range: "range", "范围";
    Coupled: "The motors move the joints through", "电机通过下式驱动各关节";
    /// Before the caption of a figure where there is no picture.
    Figure: "Figure", "图";
    FigureArm: "The arm at {}. The x axes are red, the z axes blue; cylinders turn, boxes slide.", "机械臂，取 {}。红色为 x 轴，蓝色为 z 轴；圆柱为转动关节，方块为移动关节。";
    FigurePostures: "The configurations of these solutions, in the order of the table.", "各解对应的构型，顺序与表一致。";
    FigureRings: "The points that the tip reaches, in {}, with the number of solutions; on the circles two of them fall together.", "末端可达区域（单位 {}）及各区域的解数；在圆周上两个解重合。";
    FigureReach: "The points that the tip reaches, in {}.", "末端可达区域（单位 {}）。";
    FigureDexterous: "The points that the tip reaches, in {}; in the darker region it can be turned to every angle.", "末端可达区域（单位 {}）；深色区域内末端可取任意姿态角。";
    Links: "Link transforms", "连杆变换";
    General: "Row i of the table gives the link transform", "表中第 i 行给出连杆变换";
    Short: "Sines and cosines are abbreviated: {}.", "正弦和余弦的缩写：{}。";
    Forward: "Forward kinematics", "正运动学";
    FromTheTip: "We multiply from the tip towards the base; links with parallel axes are joined first, so that their angles add up.",
        "由末端向基座逐次相乘；轴线平行的杆件先合并，使其角度相加。";
    Paul: "{} is the transform of row {}; products from the base are called T: {}.", "{} 是第 {} 行的变换；从基座起的乘积记为 T：{}。";
    With: "with {}", "其中 {}";
    BaseAndTool: "With the constant transforms of base and tool", "加上基座和工具的常量变换";
    /// Poses that are fields; then the tool's pose as a product.
    LeftOut: "The program sets {} while it runs. All formulas are those of the arm between these poses; the pose of the tool is {}.",
        "{} 由程序在运行时给定。所有公式都针对这些位姿之间的机械臂；工具位姿为 {}。";
    /// The same beside a plan.
    LeftOutOfPlan: "The program sets {} while it runs; the plan is that of the arm between these poses, whose target follows from the tool's.",
        "{} 由程序在运行时给定；此方案针对这些位姿之间的机械臂，其目标由工具的目标得出。";
    ToolPoint: "The tool's point in the last frame, {}, follows from these poses.", "工具点在末坐标系中的坐标 {} 由这些位姿确定。";
    /// Between the equations of a legend.
    Between: ", ", "，";
    /// Between a list and the next equation of a legend.
    Then: "; ", "；";
    Legend: "Abbreviations: {}.", "缩写：{}。";
    TooLong: "Written out, this product has {} terms; it is left as a product here.", "该乘积展开后有 {} 项，这里保留乘积形式。";
    Inverse: "Inverse kinematics", "逆运动学";
    Wanted: "Given is the pose {}, with direction cosines {} and position {}; wanted are the joint variables. Every step uses elements of transforms between two frames of the arm, which are also known from the given pose and the joints found before.",
        "已知位姿 {}，其方向余弦为 {}，位置为 {}；求各关节变量。每一步使用机械臂两个坐标系之间变换的元素，它们也可由已知位姿和前面求出的关节得到。";
    WithoutBaseAndTool: "Without base and tool this is", "去掉基座和工具，得";
    PrimedFrames: "Frames with a prime stand beside frames of the table:", "带撇号的坐标系与表中坐标系之间的关系为：";
    TaskAxis: "Only the position and the direction of the last z axis are asked for. The turn {} about it is open: it counts as one more joint, whose value does not matter.",
        "只要求位置和最后 z 轴的方向。绕该轴的转角 {} 不限：把它看作多出的一个关节，其值无关紧要。";
    TaskPosition: "Only the position is asked for. Three turns about the tool's point are open: they count as further joints, whose values do not matter.",
        "只要求位置。绕工具点的三个转角不限：把它们看作多出的关节，其值无关紧要。";
    TaskPlanar: "Only x, y and the angle about z are asked for. The height {} is open: it counts as one more joint, whose value does not matter.",
        "只要求 x、y 和绕 z 轴的角度。高度 {} 不限：把它看作多出的一个关节，其值无关紧要。";
    TaskInPlane: "Only x, y and the angle about z are asked for: no joint changes the height.",
        "只要求 x、y 和绕 z 轴的角度：没有关节改变高度。";
    Given: "{} is prescribed.", "{} 为给定值。";
    StepTitle: "Step {}: ", "第 {} 步：";
    KnownPose: "Known by now:", "至此已知：";
    WithEntries: "Its elements are {} and its position is {}.", "其元素为 {}，位置为 {}。";
    Where: "where {}.", "其中 {}。";
    Element: "Equating the {} elements of both sides of the equation for {},", "比较等式两边的 {} 元素（{}），得";
    Elements: "Equating the {} elements of both sides of the equation for {},", "比较等式两边的 {} 元素（{}），得";
    ElementOfInverse: "Equating the {} elements of both sides of the equation for the inverse of {},", "比较等式两边的 {} 元素（{} 的逆），得";
    ElementsOfInverse: "Equating the {} elements of both sides of the equation for the inverse of {},", "比较等式两边的 {} 元素（{} 的逆），得";
    AcrossSlides: "Around the closed loop all ways add up to nothing. Across the directions of both {} and {} neither of these lengths occurs; this component gives", "沿闭合回路各段位移之和为零。取其垂直于 {} 与 {} 两个滑动方向的分量，两者均不出现，得";
    BridgeOfSlides: "Across the directions of both {} and {} neither of these lengths occurs. In this component of the closed loop, the way between the axes of {} and {} is taken apart along both axes and their common normal; with the known angle between these axes, neither angle occurs:", "垂直于 {} 与 {} 两个滑动方向的分量不含这两个长度。在闭合回路的这一分量中，将 {} 与 {} 两轴之间的位移沿两轴及其公垂线分解；由两轴间的已知夹角，这两个角也不出现：";
    DistanceOf: "The squared distance between the origins of frames {} and {} gives", "坐标系 {} 与 {} 原点间距离的平方给出";
    Hence: "Hence", "因此";
    Sum: "with {}.", "其中 {}。";
    OneSolution: "One solution.", "一个解。";
    Solutions: "Up to {} solutions.", "最多 {} 个解。";
    SecondInstead: "Where the coefficients of the first equation vanish, the second one gives the angle in the same way.",
        "第一个方程的系数为零时，由第二个方程按同样方法求角。";
    NoneWhere: "There is none where {} is negative: the pose is out of reach.", "当 {} 为负时无解：位姿不可达。";
    FreeWhereOne: "Where {} vanishes, the arm is singular and {} is free.", "当 {} 为零时机械臂奇异，{} 可任取。";
    FreeWhere: "Where {} vanish together, the arm is singular and {} is free.", "当 {} 同时为零时机械臂奇异，{} 可任取。";
    Differences: "The remaining joints are differences:", "其余关节角由差求得：";
    Total: "Altogether there are at most {} solutions; each is confirmed by the forward kinematics.", "总共最多 {} 个解；每个解都用正运动学验证。";
    TotalOne: "Altogether there is at most one solution; it is confirmed by the forward kinematics.", "总共最多一个解；用正运动学验证。";
    Example: "Worked example", "算例";
    ExamplePose: "With {} the forward kinematics gives the pose", "取 {}，由正运动学得位姿";
    ExampleGiven: "The pose is given:", "给定位姿：";
    ExampleChosen: "{} is prescribed.", "{} 为给定值。";
    ExamplePosition: "Of this the task asks only for the position:", "任务只要求位置：";
    ExampleAxis: "Of this the task asks only for the position and the direction of the last z axis:", "任务只要求位置和最后 z 轴的方向：";
    ExamplePlanar: "Of this the task asks only for the place in the plane and the angle about z:", "任务只要求平面内的位置和绕 z 轴的角度：";
    ExampleNone: "No joint vector reaches it.", "没有关节变量能到达该位姿。";
    ExampleNotOnTask: "The arm has fewer joints than a pose has coordinates, and this pose is none of those that it can take.",
        "机械臂的关节少于位姿的坐标数，该位姿不在其可达的位姿之中。";
    ExampleTooFar: "It is too far away: step {}, which finds {}, would need a distance of {}, and the arm reaches {}.",
        "距离太远：第 {} 步（求 {}）需要距离 {}，而机械臂最远为 {}。";
    ExampleTooNear: "It is too near: step {}, which finds {}, would need a distance of {}, and the arm reaches no nearer than {}.",
        "距离太近：第 {} 步（求 {}）需要距离 {}，而机械臂最近为 {}。";
    ExampleBeyond: "Step {}, which finds {}, has no root: its equation asks for {}, and the other side is at most {}.",
        "第 {} 步（求 {}）无解：方程要求 {}，而另一边最大为 {}。";
    ExampleFree: "In solutions {} a joint is free: one of its values is shown.", "解 {} 中有关节可任取：这里只给出其中一个值。";
    ExampleClosest: "Closest to {} is solution {}.", "距 {} 最近的是第 {} 组解。";
    ExampleClosestInRange: " Of those in range it is solution {}.", "在范围内的解中，最近的是第 {} 组。";
    ExampleNoneInRange: " None is in range.", "没有一组在范围内。";
    Tree: "The same as a tree, in the order of the steps; an empty cell repeats the one above:", "按求解步骤排成树；空白单元格同上：";
    TreeSolution: "solution", "解";
    InNumbersAt: "The solution that is closest to these joint values is {}.", "与这些关节变量最接近的解为 {}。";
    InNumbers: "The steps in numbers:", "各步的数值：";
    InNumbersOf: "The steps in numbers, on the way to solution {}:", "求第 {} 组解时各步的数值：";
    OtherRoot: "the other root: {}", "另一个根：{}";
    RemarkOpen: " (", "（";
    RemarkClose: ")", "）";
    Configuration: "configuration", "构型";
    ShoulderLeft: "shoulder left", "左肩";
    ShoulderRight: "shoulder right", "右肩";
    ElbowUp: "elbow up", "上肘";
    ElbowDown: "elbow down", "下肘";
    WristNoFlip: "no flip", "腕不翻转";
    WristFlip: "flip", "腕翻转";
    InRange: "in range", "范围内";
    Yes: "yes", "是";
    No: "no", "否";
    ExampleValues: "Parameters without a value are taken as {}.", "没有给定值的参数取 {}。";
    ExampleSolutions: "The steps above yield {} solutions (checked by forward kinematics, to {} in every entry):", "上述步骤求得 {} 组关节变量均可达到该位姿（经正运动学验证，每个元素误差不超过 {}）：";
    ExampleSolution: "The steps above yield one solution (checked by forward kinematics, to {} in every entry):", "上述步骤求得一组关节变量可达到该位姿（经正运动学验证，每个元素误差不超过 {}）：";
    PlanTitle: "Inverse kinematics of {}", "{} 的逆运动学";
    PlanStep: "step", "步";
    PlanFinds: "finds", "求";
    PlanFrom: "from", "方法";
    PlanNeeds: "after", "依赖";
    PlanMost: "solutions", "解数";
    PlanNone: "none where", "无解条件";
    PlanFree: "free where these vanish", "为零时任取";
    PlanEquations: "The equations, in order:", "依次的方程：";
    PlanPoses: "Capital letters are the given pose with known motions taken off; small letters are their elements:",
        "大写字母是去掉已知运动后的位姿，小写字母是其元素：";
    PlanTotal: "At most {} solutions ({}).", "最多 {} 个解（{}）。";
    AxesParallel: "axes {} and {} are parallel", "轴 {} 与轴 {} 平行";
    AxesMeet: "axes {} and {} meet", "轴 {} 与轴 {} 相交";
    AxesSkew: "axes {} and {} are skew", "轴 {} 与轴 {} 异面";
    AxesPoint: "axes {}, {} and {} pass through one point", "轴 {}、{}、{} 交于一点";
    PlanPose: "the given pose", "已知位姿";
    NoInverse: "There is no inverse in closed form:", "没有封闭形式的逆解：";
    Jacobian: "Geometric Jacobian", "几何雅可比矩阵";
    JacobianIs: "Column {} holds the velocity of the last frame's origin and its angular velocity, in base axes, for unit speed of joint {}.",
        "第 {} 列是关节 {} 以单位速度运动时末端坐标系原点的线速度和角速度（在基座坐标系中表示）。";
    JacobianOfTool: "Column {} holds the velocity of the tool's origin and its angular velocity, in base axes, for unit speed of joint {}.",
        "第 {} 列是关节 {} 以单位速度运动时工具原点的线速度和角速度（在基座坐标系中表示）。";
    JacobianOfMotors: "Column {} holds the velocity of the last origin and its angular velocity, in base axes, for unit speed of motor {}.",
        "第 {} 列是电机 {} 以单位速度运动时末端原点的线速度和角速度（在基座坐标系中表示）。";
    Singular: "Singular configurations", "奇异位形";
    SingularHeld: "{} is held; the Jacobian of the other joints is square.", "固定 {}，其余关节的雅可比矩阵为方阵。";
    SingularAllHeld: "{} are held; the Jacobian is that of the other joints.", "固定 {}，下面是其余关节的雅可比矩阵。";
    SingularEverywhere: "The determinant vanishes at every joint vector: the joints never give all the motions that the task asks for.",
        "行列式恒为零：各关节始终不能产生任务要求的全部运动。";
    SingularTooLong: "Even where most entries vanish, a block of {} rows remains whose determinant is too long to be written out.",
        "即使取零元素最多的写法，仍剩下 {} 阶的块，其行列式过长，此处不展开。";
    SingularWide: "The Jacobian has {} columns and six rows; the arm is singular where all its minors of six rows vanish.",
        "雅可比矩阵有 {} 列、六行；当其所有六阶子式为零时机械臂奇异。";
    SingularTall: "The Jacobian has {} columns and six rows, so it has no determinant; the arm is singular where its columns depend on each other.",
        "雅可比矩阵有 {} 列、六行，没有行列式；当各列线性相关时机械臂奇异。";
    SingularGram: "The Jacobian has {} columns and six rows; its columns depend on each other where",
        "雅可比矩阵有 {} 列、六行；各列线性相关当且仅当下式为零：";
    SingularGramWhere: "vanishes (lengths and angles are taken as numbers here).", "（这里长度和角度都作为数值。）";
    SingularNever: "This never vanishes: the arm has no singular configuration.", "它不会为零：机械臂没有奇异位形。";
    SingularWritten: "The determinant of the Jacobian depends neither on the point whose velocity is meant nor on the axes along which the parts of a column are written. With the origin of {} as the point, the linear parts along the axes of {} and the angular parts along those of {}, the columns are",
        "雅可比行列式与取哪一点的速度、各列沿哪组坐标轴书写无关。取{}的原点为参考点，线速度沿{}的轴书写，角速度沿{}的轴书写，各列为";
    SingularAxis: "The turn about the tool's z axis does not count; it stands as one more column.", "绕工具 z 轴的转动不计，它作为附加的一列。";
    SingularOnly: "Only the velocity along {} and the turn about {} count.", "只考虑沿 {} 的速度和绕 {} 的转动。";
    SingularOnlySlides: "Only the velocity along {} counts.", "只考虑沿 {} 的速度。";
    SingularOnlyTurns: "Only the turn about {} counts.", "只考虑绕 {} 的转动。";
    Frame: "frame {}", "坐标系 {} ";
    FrameOfTool: "the tool", "工具坐标系";
    FrameOfBase: "the base", "基座坐标系";
    SingularStars: "Entries {} do not matter: the matrix falls into blocks, and its determinant is the product of theirs.",
        "记为 {} 的元素不影响结果：矩阵分成若干块，行列式是各块行列式之积。";
    SingularBlocks: "The matrix falls into blocks, and its determinant is the product of theirs.", "矩阵分成若干块，行列式是各块行列式之积。";
    SingularProduct: "Therefore", "于是";
    SingularLong: "where {} has {} terms; no further factor was found.", "其中 {} 有 {} 项，没有找到更多因子。";
    SingularWhere: "The arm is singular where a factor vanishes:", "任一因子为零时机械臂奇异：";
    SingularThat: ", that is ", "，即 ";
    SingularMotors: "This is the determinant for the joints; for the motors it is multiplied by that of the coupling, {}.", "这是对关节的行列式；对电机还要乘以耦合矩阵的行列式 {}。";
    Or: " or ", " 或 ";
    OrHalfTurn: " and that plus ", "，以及再加 ";
    Colon: ": ", "：";
    Stop: ".", "。";
    WristCentre: "the wrist centre (the origin of {})", "腕心（{}的原点）";
    OriginOf: "the origin of {}", "{}的原点";
    KindParallel: "the axes of joints {} and {} are parallel", "关节 {} 与关节 {} 的轴平行";
    KindAxes: "the parallel axes of joints {}, {} and {} lie in one plane, the arm is stretched or folded", "关节 {}、{}、{} 的平行轴共面，手臂伸直或折叠";
    KindStretched: "the parallel axes of joints {} and {} and {} lie in one plane, the arm is stretched or folded", "关节 {} 与关节 {} 的平行轴和{}共面，手臂伸直或折叠";
    KindOnAxis: "{} lies on the axis of joint {}", "{}位于关节 {} 的轴上";
    KindInPlane: "{} lies in the plane through the axis of joint {} parallel to the axis of joint {}", "{}位于过关节 {} 的轴且平行于关节 {} 的轴的平面内";
    KindCoplanar: "the axes of joints {}, {} and {} are parallel to one plane", "关节 {}、{}、{} 的轴平行于同一平面";
    PlaceWrist: " (wrist singularity)", "（腕部奇异）";
    PlaceElbow: " (elbow singularity)", "（肘部奇异）";
    PlaceShoulder: " (shoulder singularity)", "（肩部奇异）";
    Workspace: "Workspace", "工作空间";
    Subspace: "With {} joints the poses of the arm form a {}-dimensional subset of the 6-dimensional space of poses.",
        "机械臂有 {} 个关节，其位姿在刚体的六维中只构成 {} 维的子空间。";
    SubspaceEntries: "All poses have in common", "所有位姿都满足";
    SubspaceTurn: "The position of the last origin, ({}, {}), determines the pose: the joints are", "末端原点的位置（{}，{}）唯一确定位姿：各关节为";
    SubspaceMatrix: "and the pose is (a second one has the other sign of the root)", "位姿为（根号取负号得到另一个）";
    RingLinks: "All axes are parallel. Seen along them the arm is a chain of links with lengths {}.", "所有轴平行。沿轴方向看，机械臂是平面连杆链，杆长为 {}。";
    RingReach: "Reachable workspace: the ring about the first axis whose distance {} lies between these bounds:",
        "可达工作空间：绕第一轴的圆环，到轴的距离 {} 介于下列界限之间：";
    RingTwo: "Inside the ring there are two solutions for a place (elbow on either side), on its edges one.", "环内每个位置有两个解（肘在两侧），边界上一个解。";
    Dexterous: "Dexterous workspace, where the last link can point in every direction: a circle with its length about the place must lie in the ring of the links before, whose radii are",
        "灵巧工作空间（末杆可指向任意方向）：以该点为圆心、末杆长为半径的圆须落在前面各杆的圆环内，其半径为";
    DexterousWhere: "That is so where {} and, besides, {} or {}.", "即 {}，并且 {} 或 {}。";
    DexterousNumbers: "In numbers: {}.", "数值：{}。";
    DexterousNumbersTwo: "In numbers: {}, and {}.", "数值：{}，以及 {}。";
    DexterousEmpty: "With the values of the table there is no such place.", "按表中数值，不存在这样的位置。";
    DexterousAll: "The last frame sits on the last axis: it takes every direction wherever it can be, so the dexterous workspace is the reachable one.",
        "末端坐标系位于最后一根轴上，可达之处均可取任意方向：灵巧工作空间即可达工作空间。";
    DexterousPoint: "Dexterous workspace: the links are equally long, so the last one can point in every direction at the centre alone.",
        "灵巧工作空间：两杆等长，只有圆心处末杆可指向任意方向。";
    DexterousNone: "Dexterous workspace: empty, since {} and {} differ.", "灵巧工作空间：空集，因为 {} 与 {} 不相等。";
    DexterousTwo: "Dexterous workspace: the centre alone if {} = {}, else empty.", "灵巧工作空间：若 {} = {}，只有圆心；否则为空集。";
    RingLimited: "The ranges of joints {} leave only a part of this.", "关节 {} 的范围只允许其中一部分。";
    RingElbow: "The range of the elbow keeps the distance between {} and {}.", "肘关节的范围使距离介于 {} 与 {} 之间。";
    RingHeight: "Joint {} moves this along the axes, by {} in all.", "关节 {} 使其沿轴方向移动，总行程 {}。";
}
