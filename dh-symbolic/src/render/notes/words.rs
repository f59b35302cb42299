//! All prose of the notes, in every language. `{}` takes a formula or name.

/// Language of a note.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Language {
    /// English.
    #[default]
    English,
    /// Chinese, simplified.
    Chinese,
}

impl Language {
    /// Language tag.
    pub fn tag(self) -> &'static str {
        match self {
            Language::English => "en",
            Language::Chinese => "zh",
        }
    }
}

macro_rules! phrases {
    ($($(#[$doc:meta])* $name:ident: $english:literal, $chinese:literal;)*) => {
        /// Everything that a note can say.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub(super) enum Phrase {
            $($(#[$doc])* $name,)*
        }

        impl Phrase {
            /// The words.
            pub(super) fn in_language(self, language: Language) -> &'static str {
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
    Modified: "Modified convention (Craig): frame {} sits on the axis of joint {}; row {} holds the twist and length of the link before.",
        "改进型约定（Craig）：坐标系 {} 位于关节 {} 的轴上；第 {} 行给出前一杆件的扭角和长度。";
    Standard: "Standard convention: frame {} sits at the far end of link {}, on the axis of joint {}.",
        "标准型约定：坐标系 {} 位于杆件 {} 的末端，即关节 {} 的轴上。";
    Lengths: "Lengths in {}: ", "长度单位 {}：";
    Angles: "Constant angles: ", "常量角：";
    Free: "Free parameters: ", "自由参数：";
    Fixed: "fixed", "固定";
    Range: "range", "范围";
    Coupled: "The motors move the joints through", "电机通过下式驱动各关节";
    Links: "Link transforms", "杆件变换";
    General: "One row of the table is the transform", "表中一行对应的变换为";
    Short: "Sines and cosines are abbreviated: {}.", "正弦和余弦的缩写：{}。";
    Forward: "Forward kinematics", "正运动学";
    FromTheTip: "The product is formed from the tip to the base; links with parallel axes are joined first, so that their angles add up.",
        "乘积从末端向基座逐步形成；轴线平行的杆件先合并，使其角度相加。";
    With: "with {}", "其中 {}";
    BaseAndTool: "With the constant transforms of base and tool", "加上基座和工具的常量变换";
    /// Between the equations of a legend.
    Between: ", ", "，";
    /// Between a list and the next equation of a legend.
    Then: "; ", "；";
    Legend: "Abbreviations: {}.", "缩写：{}。";
    TooLong: "Written out, this product has {} terms; it is left as a product here.", "该乘积展开后有 {} 项，这里保留乘积形式。";
    Jacobian: "Geometric Jacobian", "几何雅可比矩阵";
    JacobianIs: "Column {} holds the velocity of the last frame's origin and its angular velocity, in base axes, for unit speed of joint {}.",
        "第 {} 列是关节 {} 以单位速度运动时末端坐标系原点的线速度和角速度（在基座坐标系中表示）。";
    JacobianOfTool: "Column {} holds the velocity of the tool's origin and its angular velocity, in base axes, for unit speed of joint {}.",
        "第 {} 列是关节 {} 以单位速度运动时工具原点的线速度和角速度（在基座坐标系中表示）。";
    JacobianOfMotors: "Column {} holds the velocity of the last origin and its angular velocity, in base axes, for unit speed of motor {}.",
        "第 {} 列是电机 {} 以单位速度运动时末端原点的线速度和角速度（在基座坐标系中表示）。";
}
